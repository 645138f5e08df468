package org.u2sa.scenarios.ugv;

import org.u2sa.sim.sensor.GpsParameters;

/** Grade of the demo's GPS receiver, in factory settings; the board's service configures it. */
enum GpsGrade {
  /** Real-time kinematic: 2 cm. */
  SURVEY("survey", "survey-grade GPS", GpsParameters.survey(), 1.0, 0.0, 60.0),
  /** Phone: 3 m drifting error, 1 Hz, with latency. */
  PHONE("phone", "phone-grade GPS", GpsParameters.phone(), 2.5, 1.5, 120.0);

  private static final double FIRST_MESSAGE_S = 36.0 * 10.0 / 9600.0;

  private final String preset;
  private final String words;
  private final GpsParameters parameters;
  private final double fixTimeoutS;
  private final double leastThresholdM;
  private final double correlationS;

  GpsGrade(
      String preset,
      String words,
      GpsParameters parameters,
      double fixTimeoutS,
      double leastThresholdM,
      double correlationS) {
    this.preset = preset;
    this.words = words;
    this.parameters = parameters;
    this.fixTimeoutS = fixTimeoutS;
    this.leastThresholdM = leastThresholdM;
    this.correlationS = correlationS;
  }

  /** Name in reports. */
  String words() {
    return words;
  }

  /** Its name in the presets of vehicle files. */
  String preset() {
    return preset;
  }

  /** The State Estimator's STALE AFTER; must exceed the fix interval [s]. */
  double fixTimeoutS() {
    return fixTimeoutS;
  }

  /**
   * Minimum waypoint threshold [m]: with position jumps of half a metre, smaller ones are missed.
   */
  double leastThresholdM() {
    return leastThresholdM;
  }

  /**
   * Latency from the time of validity of a fix to the arrival of its first message at the board
   * [s]: NAV-POSLLH takes 36 bytes at 9600 baud.
   */
  double delayS() {
    return parameters.latencyS() + FIRST_MESSAGE_S;
  }

  /** The State Estimator's POSITION CORRELATION: correlation time of the errors [s]. */
  double correlationS() {
    return correlationS;
  }
}
