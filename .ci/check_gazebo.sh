#!/usr/bin/env bash
# Checks of the exported Gazebo packages on a machine without Gazebo (docs/gazebo.md): parsed by
# libsdformat, built by catkin and ament, the launch file parsed by roslaunch, and the torque messages
# received over ROS 1 and ROS 2.  Each check is also given a planted fault, which it must refuse.
#
#   .ci/check_gazebo.sh [PYTHON]      PYTHON: the interpreter that has ur5check and Drake
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
python=$(cd "$here/.." && realpath -s "${1:-.venv/bin/python}")
ros1=/usr/bin/python3 # Debian's ROS 1 belongs to Debian's Python
scratch=$(mktemp -d)
started=()
finish() {
    for process in "${started[@]}"; do kill "$process" 2>/dev/null || true; done
    wait
    rm -rf "$scratch"
}
trap finish EXIT

refuses() { # refuses FAULT WORDS COMMAND…: the command must fail with a message that contains WORDS
    local fault=$1 words=$2
    shift 2
    if "$@" >"$scratch/output" 2>&1; then
        echo "planted fault passed: $fault" >&2
        exit 1
    fi
    if ! grep -qF -- "$words" "$scratch/output"; then
        echo "planted fault was refused for another reason: $fault" >&2
        cat "$scratch/output" >&2
        exit 1
    fi
    echo "refused, as it must be: $fault"
}

echo "--- Debian: libsdformat, catkin, roslaunch, rospy"
if ! apt-get install -qq -y --no-install-recommends catkin cmake ignition-tools libsdformat-dev \
    python3-roslaunch python3-rosmaster python3-rospy python3-std-msgs >/dev/null 2>&1; then
    apt-get update -qq
    apt-get install -qq -y --no-install-recommends catkin cmake ignition-tools libsdformat-dev \
        python3-roslaunch python3-rosmaster python3-rospy python3-std-msgs >/dev/null
fi

echo "--- PyPI: rclpy and ament"
"$python" -m venv "$scratch/ros2"
"$scratch/ros2/bin/pip" install --quiet "ros-rclpy[fastrtps]>=9.1,<10" "ros-std-msgs>=5.5,<6" \
    "ros-ament-cmake>=2.7,<3" "ros-ament-cmake-include-directories>=2.7,<3" \
    "ros-ament-package>=0.17,<1" \
    "catkin-pkg>=1,<2" "xacro>=2.1,<3" 2>"$scratch/pip" || { cat "$scratch/pip" >&2; exit 1; }

echo "--- export"
cd "$scratch"
"$python" -m ur5check export gazebo exported --quiet
package=appendix_gazebo
one=$scratch/exported/ros1/$package
two=$scratch/exported/ros2/$package
joints=(shoulder_pan_joint shoulder_lift_joint elbow_joint wrist_1_joint wrist_2_joint wrist_3_joint)
pose='[0, 0.9, -1.0, 1.0, 3.5, -1.9]' # the paper's case 9

"$python" -m ruff check --isolated --select E,F,W --line-length 200 exported

echo "--- libsdformat"
sdf() { ign sdf "$@" 2> >(grep -v libignition-tools-backward >&2); }
sdf_is_valid() { sdf -k "$1" | tee "$scratch/verdict" && grep -qx Valid. "$scratch/verdict"; }
for variant in appendix appendix_limited; do
    sdf -p "$two/urdf/$variant.urdf" >"$variant.sdf" 2>"$scratch/warnings"
    if grep -qiE "warning|error" "$scratch/warnings"; then
        cat "$scratch/warnings" >&2
        exit 1
    fi
    sdf_is_valid "$variant.sdf"
    "$python" "$here/gazebo/torque_of_sdf.py" appendix "$variant.sdf"
done
sdf_is_valid "$two/worlds/empty.sdf"
sdf_is_valid "$one/worlds/empty.world"
for model in paper paper-listing erd-ur5; do
    name=${model//-/_}
    # A pitch next to a quarter turn is a quarter turn to libsdformat.  erd-ur5 writes 1.57079632679,
    # 5e-12 rad less; its shoulder carries at most 60 N m, its elbow and wrist less.
    tolerance=1e-11
    test "$model" = erd-ur5 && tolerance=1e-9
    "$python" -m ur5check export gazebo "$name" --model "$model" --ros 2 --quiet >/dev/null
    for variant in "$name" "${name}_limited"; do
        sdf -p "$name/ros2/${name}_gazebo/urdf/$variant.urdf" >"$variant.sdf"
        sdf_is_valid "$variant.sdf"
        "$python" "$here/gazebo/torque_of_sdf.py" "$model" "$variant.sdf" "$tolerance"
    done
done
sed '/<inertial>/,/<.inertial>/d' "paper/ros2/paper_gazebo/urdf/paper.urdf" >wrong.urdf
sdf -p wrong.urdf >wrong.sdf 2>/dev/null
refuses "an arm that Gazebo drops" "at least one link" sdf -k wrong.sdf
sed 's/<mass>8.393/<mass>8.394/' appendix.sdf >wrong.sdf
refuses "a gram too much" "weighs something else" "$python" "$here/gazebo/torque_of_sdf.py" appendix wrong.sdf
sed 's/<parent>forearm_link/<parent>fore_arm_link/' appendix.sdf >wrong.sdf
refuses "a joint without a parent" "fore_arm_link" sdf_is_valid wrong.sdf

echo "--- ROS 1: catkin builds the package"
cmake -S "$one" -B build1 -DPYTHON_EXECUTABLE="$ros1" -DCMAKE_INSTALL_PREFIX="$scratch/install1" \
    >build1.log 2>&1 || { cat build1.log >&2; exit 1; }
cmake --install build1 >/dev/null
test -x "install1/lib/$package/torque_publisher.py"
cp -r "$one" wrong1
sed -i '/<license>/d' wrong1/package.xml
refuses "a package without a licence" "license" \
    cmake -S wrong1 -B wrong_build1 -DPYTHON_EXECUTABLE="$ros1"

echo "--- ROS 1: roslaunch reads the launch file"
PATH=$(dirname "$python"):$PATH # for xacro
export ROS_PACKAGE_PATH=$scratch/install1/share ROS_HOME=$scratch/ros_home
reads() { "$ros1" "$here/gazebo/roslaunch_reads.py" "$package" 6 "$@"; }
launch=$scratch/install1/share/$package/launch/gazebo.launch
reads "$launch"
for limited in true false; do
    for paused in true false; do
        for gui in true false; do
            reads "$launch" "limited:=$limited" "paused:=$paused" "gui:=$gui"
        done
    done
done
sed 's/joint4_effort_controller/joint5_effort_controller/' "$launch" >wrong.launch
refuses "a controller spawned twice" "spawned:" reads wrong.launch
sed 's/-z \$(arg z)/-z $(arg height)/' "$launch" >wrong.launch
refuses "an argument that is not declared" "height" reads wrong.launch
sed 's/<remap/<removed/' "$launch" >wrong.launch
refuses "joint states looked for elsewhere" "remapped" reads wrong.launch

echo "--- ROS 1: the torque is published"
export ROS_MASTER_URI=http://127.0.0.1:11399 ROS_IP=127.0.0.1
"$ros1" -c 'import rosmaster; rosmaster.rosmaster_main()' --core -p 11399 >master.log 2>&1 &
started+=($!)
publish1() { # the node as the launch file starts it
    "$ros1" -c '
import sys, rosparam, rospy
for params, namespace in rosparam.load_file(sys.argv[1], "/ur/torque_publisher"):
    rosparam.upload_params(namespace, params)
rospy.set_param("/ur/torque_publisher/own_model", sys.argv[2])
rospy.set_param("/ur/torque_publisher/python", sys.argv[3])
' "install1/share/$package/config/torque.yaml" \
        "$scratch/install1/share/$package/urdf/appendix.urdf" "$python"
    exec "$ros1" "install1/lib/$package/torque_publisher.py" __ns:=/ur
}
tries=0
until "$ros1" -c 'import rosgraph, sys; sys.exit(not rosgraph.is_master_online())'; do
    if [ $((tries += 1)) -gt 50 ]; then
        cat master.log >&2
        exit 1
    fi
    sleep 0.2
done
publish1 >publisher1.log 2>&1 &
started+=($!)
heard=$("$ros1" "$here/gazebo/hears_ros1.py" 6) || { cat publisher1.log >&2; exit 1; }
"$python" "$here/gazebo/same_torque.py" appendix "$pose" "$heard"
refuses "the torque of another posture" "ur5check computes" \
    "$python" "$here/gazebo/same_torque.py" appendix '[0, 0.9, -1.0, 1.0, 0.35, -1.9]' "$heard"

echo "--- ROS 2: ament builds the package"
ros2=$scratch/ros2/bin/python
cmake -S "$two" -B build2 -DCMAKE_PREFIX_PATH="$scratch/ros2" -DPython3_EXECUTABLE="$ros2" \
    -DCMAKE_INSTALL_PREFIX="$scratch/install2" >build2.log 2>&1 || { cat build2.log >&2; exit 1; }
cmake --install build2 >/dev/null
cp -r "$two" wrong2
sed -i 's/<version>0.1.0/<version>first/' wrong2/package.xml
refuses "a version that is none" "version" cmake -S wrong2 -B wrong_build2 \
    -DCMAKE_PREFIX_PATH="$scratch/ros2" -DPython3_EXECUTABLE="$ros2"

echo "--- ROS 2: xacro finds the package, and rcl its parameters"
export AMENT_PREFIX_PATH=$scratch/install2 ROS_LOG_DIR=$scratch/log
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
share=$scratch/install2/share/$package
for limited in true false; do
    "$scratch/ros2/bin/xacro" "$share/urdf/gazebo.urdf.xacro" "limited:=$limited" >whole.urdf
    grep -qF "<parameters>$share/config/controllers.yaml</parameters>" whole.urdf
    test "$(grep -c '<command_interface name="effort"/>' whole.urdf)" = 6
    sdf -p whole.urdf >whole.sdf
    sdf_is_valid whole.sdf
    "$python" "$here/gazebo/torque_of_sdf.py" appendix whole.sdf
done
AMENT_PREFIX_PATH='' refuses "a package that is not installed" "appendix_gazebo" \
    "$scratch/ros2/bin/xacro" "$share/urdf/gazebo.urdf.xacro"
reads2() { "$ros2" "$here/gazebo/parameters_ros2.py" "$1" "${joints[@]}"; }
reads2 "$share/config/controllers.yaml"
sed 's/wrist_1_joint/wrist_2_joint/' "$share/config/controllers.yaml" >wrong.yaml
refuses "a controller for another's joint" "not the effort of 'wrist_1_joint'" reads2 wrong.yaml
sed 's#^/ur/joint3#/ru/joint3#' "$share/config/controllers.yaml" >wrong.yaml
refuses "a controller outside the namespace" "joint3_effort_controller drives" reads2 wrong.yaml

echo "--- ROS 2: the torque is published"
"$ros2" "install2/lib/$package/torque_publisher.py" --ros-args -r __ns:=/ur \
    --params-file "$share/config/torque.yaml" \
    -p "own_model:=$share/urdf/appendix.urdf" -p "python:=$python" >publisher2.log 2>&1 &
started+=($!)
heard=$("$ros2" "$here/gazebo/hears_ros2.py" 6) || { cat publisher2.log >&2; exit 1; }
"$python" "$here/gazebo/same_torque.py" appendix "$pose" "$heard"

echo "Gazebo packages: all checks passed"
