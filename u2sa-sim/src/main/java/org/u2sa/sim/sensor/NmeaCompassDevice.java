package org.u2sa.sim.sensor;

import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * A compass that streams its heading as NMEA 0183 sentences. Time advances in {@link #advance}. Not
 * thread-safe.
 */
public final class NmeaCompassDevice {
  /** Sentence type. */
  public enum Sentence {
    /** Magnetic heading. */
    HDM,
    /** Magnetic heading and the configured declination. */
    HDG,
    /** True heading, using the configured declination. */
    HDT
  }

  private static final int BUFFER = 256;
  private static final double US_PER_S = 1e6;
  private static final double TURN_RAD = 2.0 * Math.PI;
  private static final double TURN_DEG = 360.0;

  private final Sentence sentence;
  private final double declinationRad;
  private final CompassModel model;
  private final UartTransmitter line;
  private final long periodUs;
  private long nextUs;

  /**
   * @param baud line rate [bit/s]; 4800 is the NMEA 0183 default
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
   * Advances time; the compass measures and sends at its own rate.
   *
   * @param micros time of the run [µs], non-decreasing
   * @param field current magnetic disturbance
   */
  public void advance(long micros, VehicleTruth truth, CompassModel.Disturbance field) {
    if (micros >= nextUs) {
      line.send(micros, bytes(sentence, model.sample(truth, field), declinationRad));
      nextUs = (micros / periodUs + 1) * periodUs;
    }
  }

  static byte[] bytes(Sentence sentence, double magneticRad, double declinationRad) {
    return switch (sentence) {
      case HDM -> heading("HCHDM", magneticRad).text("M").bytes();
      case HDG ->
          heading("HCHDG", magneticRad)
              .blank(2)
              .number(Math.abs(Math.toDegrees(declinationRad)), 1, 1)
              .text(declinationRad < 0.0 ? "W" : "E")
              .bytes();
      case HDT ->
          heading("HCHDT", (magneticRad + declinationRad + TURN_RAD) % TURN_RAD).text("T").bytes();
    };
  }

  /** A sentence with a heading of 0…359.9 degrees; values that round to 360 become 0. */
  private static NmeaOutput heading(String sentence, double radians) {
    double rounded = Math.round(Math.toDegrees(radians) * 10.0) / 10.0;
    return new NmeaOutput(sentence)
        .number(rounded >= TURN_DEG ? rounded - TURN_DEG : rounded, 1, 1);
  }

  /** Time at which {@link #advance} next has work [µs]. */
  public long nextUs() {
    return nextUs;
  }

  /** Its transmit line. */
  public UartTransmitter line() {
    return line;
  }
}
