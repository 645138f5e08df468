package org.u2sa.service;

/** Why an actuator does not obey a command. */
public enum CommandRefusal {
  /**
   * It is for an actuator that is not here: no fault of the command, so neither said nor summed.
   */
  NOT_ADDRESSED("for another actuator"),
  /** An emergency stop holds. */
  EMERGENCY_STOPPED("emergency stop"),
  /** The actuator requires arming, and the vehicle is not armed. */
  NOT_ARMED("not armed"),
  /** It is of another system. */
  WRONG_SYSTEM("from another system"),
  /** It says something else than a percentage. */
  NOT_A_PERCENTAGE("not a percentage"),
  /** It says something that the actuator did not announce to take. */
  NOT_TAKEN("of a kind that the actuator does not take"),
  /** It is no number, or outside what the actuator announced. */
  OUT_OF_RANGE("out of range"),
  /** It expired on its way. */
  TOO_OLD("too old"),
  /** Its timestamp is farther ahead of this clock than clocks differ. */
  FROM_THE_FUTURE("from the future");

  private final String words;

  CommandRefusal(String words) {
    this.words = words;
  }

  /** The reason in words, as logs have it. */
  @Override
  public String toString() {
    return words;
  }
}
