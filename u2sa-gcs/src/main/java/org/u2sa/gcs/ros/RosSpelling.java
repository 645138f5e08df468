package org.u2sa.gcs.ros;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.JsonText;

/**
 * A client's notation of types and times: {@code nav_msgs/Odometry} with {@code secs} and {@code
 * nsecs} (ROS 1), or {@code nav_msgs/msg/Odometry} with {@code sec} and {@code nanosec} (ROS 2).
 */
enum RosSpelling {
  ROS_1("secs", "nsecs"),
  ROS_2("sec", "nanosec");

  private static final String ROS_2_FOLDER = "/msg/";
  private static final long NANOS = 1_000_000_000L;

  /** A time or duration [ns]. */
  record Time(long nanos) {}

  /** A {@code std_msgs/Header}. */
  record Header(Time stamp, String frameId) {}

  private final String seconds;
  private final String nanoseconds;

  RosSpelling(String seconds, String nanoseconds) {
    this.seconds = seconds;
    this.nanoseconds = nanoseconds;
  }

  /** The spelling of a type; ROS 2 if none is named. */
  static RosSpelling of(String type) {
    return type.isEmpty() || type.contains(ROS_2_FOLDER) ? ROS_2 : ROS_1;
  }

  /** A type's name in the spelling of ROS 2. */
  static String ros2(String type) {
    boolean isRos1 = type.indexOf('/') > 0 && type.indexOf('/') == type.lastIndexOf('/');
    return isRos1 ? type.replace("/", ROS_2_FOLDER) : type;
  }

  /** Fields of a message, by alternating names and values. */
  static Map<String, Object> fields(Object... namesAndValues) {
    Map<String, Object> fields = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      fields.put((String) namesAndValues[i], namesAndValues[i + 1]);
    }
    return fields;
  }

  /**
   * A value in a form that {@link JsonText} accepts. Numbers that JSON cannot represent become
   * null, as in rosbridge's own server.
   */
  Object json(Object value) {
    if (value instanceof Time time) {
      return new JsonText()
          .put(seconds, Math.floorDiv(time.nanos(), NANOS))
          .put(nanoseconds, Math.floorMod(time.nanos(), NANOS));
    }
    if (value instanceof Header header) {
      JsonText json = new JsonText();
      if (this == ROS_1) {
        json.put("seq", 0);
      }
      return json.put("stamp", json(header.stamp())).put("frame_id", header.frameId());
    }
    if (value instanceof Map<?, ?> map) {
      JsonText json = new JsonText();
      map.forEach((name, each) -> put(json, (String) name, json(each)));
      return json;
    }
    if (value instanceof List<?> list) {
      List<Object> elements = new ArrayList<>(list.size());
      list.forEach(each -> elements.add(json(each)));
      return elements;
    }
    boolean isNumber = !(value instanceof Double number) || Double.isFinite(number);
    return isNumber ? value : null;
  }

  private static void put(JsonText json, String name, Object value) {
    if (value == null) {
      json.putNull(name);
    } else {
      json.put(name, value);
    }
  }
}
