package org.u2sa.sim.sensor;

/**
 * A compass that sends its heading by itself, as NMEA 0183 sentences. Its time moves in {@link
 * #advance}. Not safe for several threads.
 */
public final class NmeaCompassDevice {
  /** Which sentence it sends. */
  public enum Sentence {
    /** Magnetic heading. */
    HDM,
    /** Magnetic heading, and the declination that the compass was told. */
    HDG,
    /** True heading, with the declination that the compass was told. */
    HDT
  }

  private static final int BUFFER = 256;
  private static final double US_PER_S = 1e6;
  private static final double TURN_RAD = 2.0 * Math.PI;

  private final Sentence sentence;
  private final double declinationRad;
  private final CompassModel model;
  private final UartTransmitter line;
  private final long periodUs;
  private long nextUs;

  /**
   * @param baud of its line [bit/s]; 4800 is NMEA's own
   */
  public NmeaCompassDevice(
      int baud, Sentence sentence, CompassParameters parameters, NoiseStreams streams) {
    this.sentence = sentence;
    this.declinationRad = parameters.declinationRad();
    model = new CompassModel(parameters, streams);
    line = new UartTransmitter(baud, BUFFER);
    periodUs = Math.round(US_PER_S / parameters.rateHz());
  }

  /**
   * Time passes; the compass measures and sends at its own rate.
   *
   * @param micros the run's time [µs], not before that of the last call
   * @param field what disturbs it
   */
  public void advance(long micros, TrueMotion truth, CompassField field) {
    if (micros >= nextUs) {
      line.send(micros, bytes(model.sample(truth, field)));
      nextUs = (micros / periodUs + 1) * periodUs;
    }
  }

  private byte[] bytes(double magneticRad) {
    return switch (sentence) {
      case HDM -> NmeaCompassMessages.hdm(magneticRad);
      case HDG -> NmeaCompassMessages.hdg(magneticRad, declinationRad);
      case HDT -> NmeaCompassMessages.hdt((magneticRad + declinationRad + TURN_RAD) % TURN_RAD);
    };
  }

  /** When {@link #advance} next has something to do [µs]. */
  public long nextUs() {
    return nextUs;
  }

  /** The line on which it sends. */
  public UartTransmitter line() {
    return line;
  }
}
