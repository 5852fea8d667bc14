"""_reports"""
