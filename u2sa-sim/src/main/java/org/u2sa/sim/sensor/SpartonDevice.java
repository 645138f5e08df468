package org.u2sa.sim.sensor;

import java.io.ByteArrayOutputStream;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Device side of a Sparton smart compass (SP3004D and successors), legacy binary protocol of
 * Sparton's Software Interface User's Manual: A4, command, data, A0. It answers
 *
 * <ul>
 *   <li>02 true heading and 09 magnetic heading, 4096 units per turn
 *   <li>06 pitch and roll, both 0 here
 *   <li>83 set the declination in tenths of a degree
 *   <li>57 set the baud rate
 * </ul>
 *
 * and AE for unknown commands. Time advances in {@link #advance}. Not thread-safe.
 */
public final class SpartonDevice {
  private static final int BUFFER = 256;
  private static final int BEGIN = 0xA4;
  private static final int ERROR = 0xAE;
  private static final int END = 0xA0;
  private static final int TRUE_HEADING = 0x02;
  private static final int PITCH_ROLL = 0x06;
  private static final int MAGNETIC_HEADING = 0x09;
  private static final int BAUD = 0x57;
  private static final int DECLINATION = 0x83;
  private static final int[] BAUDS = {0, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
  private static final double US_PER_S = 1e6;
  private static final double TURN = 4096.0;
  private static final double TENTHS = 10.0;

  private final CompassModel model;
  private final UartTransmitter line;
  private final long periodUs;
  private final byte[] request = new byte[5];
  private int size;
  private long nowUs;
  private long nextUs;
  private double magneticRad;
  private int declinationTenths;

  /**
   * @param baud line rate [bit/s]; factory setting 115200
   */
  public SpartonDevice(int baud, CompassParameters parameters, NoiseStreams streams) {
    model = new CompassModel(parameters, streams);
    line = new UartTransmitter(baud, BUFFER);
    periodUs = Math.round(US_PER_S / parameters.rateHz());
  }

  /**
   * Advances time; the compass measures at its own rate.
   *
   * @param micros the run's time [µs], not before the last call's
   * @param field current magnetic disturbance
   */
  public void advance(long micros, VehicleTruth truth, CompassModel.Disturbance field) {
    nowUs = micros;
    if (micros >= nextUs) {
      magneticRad = model.sample(truth, field);
      nextUs = (micros / periodUs + 1) * periodUs;
    }
  }

  /** Time at which {@link #advance} next has work [µs]. */
  public long nextUs() {
    return nextUs;
  }

  /** Its transmit line. */
  public UartTransmitter line() {
    return line;
  }

  /**
   * Receives bytes from the host.
   *
   * @param micros the run's time [µs], not before the last call's
   * @param baud the host's rate; bytes at a different rate than the compass's are ignored
   * @param length number of valid bytes
   */
  public void accept(long micros, int baud, byte[] bytes, int length) {
    nowUs = micros;
    for (int i = 0; baud == line.baud() && i < length; i++) {
      accept(bytes[i] & 0xFF);
    }
  }

  private void accept(int octet) {
    if (size == 0 && octet != BEGIN) {
      return;
    }
    request[size++] = (byte) octet;
    if (size == wanted()) {
      size = 0;
      if (octet == END) {
        answer(request[1] & 0xFF);
      }
    }
  }

  /** Length of the current request. */
  private int wanted() {
    if (size < 2) {
      return 3;
    }
    return switch (request[1] & 0xFF) {
      case BAUD -> 4;
      case DECLINATION -> 5;
      default -> 3;
    };
  }

  private void answer(int command) {
    switch (command) {
      case MAGNETIC_HEADING -> say(command, turnBy(0.0));
      case TRUE_HEADING -> say(command, turnBy(Math.toRadians(declinationTenths / TENTHS)));
      case PITCH_ROLL -> say(command, 0, 0);
      case DECLINATION -> {
        declinationTenths = (short) ((request[2] & 0xFF) << 8 | request[3] & 0xFF);
        say(command, declinationTenths);
      }
      case BAUD -> changeBaud(request[2] & 0xFF);
      default -> line.send(nowUs, new byte[] {(byte) ERROR, (byte) command, (byte) END});
    }
  }

  /** Echoes at the old rate and again at the new rate. */
  private void changeBaud(int code) {
    byte[] echo = {(byte) BEGIN, (byte) BAUD, (byte) code, (byte) END};
    line.send(nowUs, echo);
    if (code > 0 && code < BAUDS.length) {
      line.baud(BAUDS[code]);
      line.send(nowUs, echo);
    }
  }

  private int turnBy(double radians) {
    double turns = (magneticRad + radians) / (2.0 * Math.PI);
    return (int) Math.floorMod(Math.round(turns * TURN), (long) TURN);
  }

  private void say(int command, int... words) {
    ByteArrayOutputStream answer = new ByteArrayOutputStream();
    answer.write(BEGIN);
    answer.write(command);
    for (int word : words) {
      answer.write(word >> 8);
      answer.write(word);
    }
    answer.write(END);
    line.send(nowUs, answer.toByteArray());
  }
}
