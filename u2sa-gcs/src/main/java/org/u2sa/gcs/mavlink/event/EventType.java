package org.u2sa.gcs.mavlink.event;

import java.util.List;

/** The events of a vehicle, in the order of their numbers. */
enum EventType {
  FAILSAFE(
      "Failsafe {1}: {2}",
      "The vehicle suspends its orders for the listed reasons.",
      2,
      new Argument("action", EventMetadata.ACTION),
      new Argument("causes", EventMetadata.CAUSES)),
  FAILSAFE_OVER("Failsafe over", "The vehicle follows its orders again.", 5),
  ARMING_REFUSED(
      "Not armed: {1}",
      "Arming was refused; a status text details each reason.",
      3,
      new Argument("reasons", EventMetadata.CAUSES)),
  ARMED("Armed", "The vehicle may move.", 6),
  DISARMED("Disarmed", "The vehicle must not move.", 6),
  ITEM_REACHED(
      "Mission item {1} reached",
      "Numbered as in the mission's download.", 6, new Argument("item", "uint16_t")),
  MISSION_OVER("Mission over", "The mission is complete and the vehicle holds.", 5);

  /**
   * A number that an event carries.
   *
   * @param type a basic type, or an enumeration of {@link EventMetadata}
   */
  record Argument(String name, String type) {}

  private static final int AUTOPILOT = 1 << 24; // component in the top byte of an ID

  private final String message;
  private final String description;
  private final int level;
  private final List<Argument> arguments;

  /**
   * @param level syslog level: 2 critical, 3 error, 5 notice, 6 info
   */
  EventType(String message, String description, int level, Argument... arguments) {
    this.message = message;
    this.description = description;
    this.level = level;
    this.arguments = List.of(arguments);
  }

  String message() {
    return message;
  }

  String description() {
    return description;
  }

  List<Argument> arguments() {
    return arguments;
  }

  /** Number within the component. */
  int number() {
    return ordinal() + 1;
  }

  /** Number within the system. */
  long id() {
    return AUTOPILOT | number();
  }

  /** The same level for logs and for people. */
  int levels() {
    return level << 4 | level;
  }
}
