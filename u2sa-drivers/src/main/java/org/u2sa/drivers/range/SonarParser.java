package org.u2sa.drivers.range;

/**
 * Reads a MaxBotix sonar's serial output: "R", digits, carriage return. Not safe for several
 * threads.
 */
public final class SonarParser {
  private static final int CARRIAGE_RETURN = '\r';
  private static final int BEGIN = 'R';

  private final SonarModel model;
  private int digits = -1; // seen since the R; -1: no R yet
  private int count;
  private RangeFinder.Reading reading = RangeFinder.NONE;
  private long malformed;

  /** For sonars of a family. */
  public SonarParser(SonarModel model) {
    this.model = model;
  }

  /** Takes the next bytes of the stream. */
  public void accept(byte[] bytes, int length, long nowMicros) {
    for (int i = 0; i < length; i++) {
      accept(bytes[i] & 0xFF, nowMicros);
    }
  }

  private void accept(int each, long nowMicros) {
    if (each == BEGIN) {
      malformed += digits >= 0 ? 1 : 0; // another one had begun
      digits = 0;
      count = 0;
    } else if (each >= '0' && each <= '9' && digits >= 0 && digits < model.digits()) {
      digits++;
      count = 10 * count + each - '0';
    } else if (each == CARRIAGE_RETURN && digits == model.digits()) {
      reading = new RangeFinder.Reading(nowMicros, model.rangeM(count));
      digits = -1;
    } else {
      malformed++;
      digits = -1;
    }
  }

  /** What came last, with the time at which its last byte came. */
  public RangeFinder.Reading latest() {
    return reading;
  }

  /** Bytes or lines so far that were not as they should be. */
  public long malformed() {
    return malformed;
  }

  /** Forgets what was begun: the stream was cut. */
  public void beginAnew() {
    digits = -1;
  }
}
