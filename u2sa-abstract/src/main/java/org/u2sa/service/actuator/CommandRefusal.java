package org.u2sa.service.actuator;

/** Reasons to refuse a command. */
public enum CommandRefusal {
  /** Addressed to another actuator: not an error, so neither logged nor counted. */
  NOT_ADDRESSED("for another actuator"),
  /** An emergency stop is active. */
  EMERGENCY_STOPPED("emergency stop"),
  /** The actuator requires arming, and the vehicle is not armed. */
  NOT_ARMED("not armed"),
  /** Sent by another system. */
  WRONG_SYSTEM("from another system"),
  /** Not a percentage. */
  NOT_A_PERCENTAGE("not a percentage"),
  /** Of a type the actuator did not announce. */
  NOT_TAKEN("of a type that the actuator does not accept"),
  /** Not a number, or outside the announced range. */
  OUT_OF_RANGE("out of range"),
  /** Expired in transit. */
  TOO_OLD("too old"),
  /** Timestamp ahead of this clock by more than the tolerance. */
  FROM_THE_FUTURE("from the future");

  private final String words;

  CommandRefusal(String words) {
    this.words = words;
  }

  /** Reason as logged. */
  @Override
  public String toString() {
    return words;
  }
}
