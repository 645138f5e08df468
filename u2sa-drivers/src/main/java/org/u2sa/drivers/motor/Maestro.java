package org.u2sa.drivers.motor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Servo;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * One channel of a Pololu Maestro servo controller: targets out, positions in (Maestro User's
 * Guide, section 5.e, compact protocol). The controller holds the last target.
 */
public final class Maestro extends LinkedDevice<Servo.Position> implements Servo {
  private static final int SET_TARGET = 0x84;
  private static final int GET_POSITION = 0x90;
  private static final double QUARTERS_PER_US = 4.0;
  private static final long ASK_EVERY_MICROS = Clock.micros(0.1);
  private static final int LOW_BITS = 0x7f;
  private static final int LONGEST_US = 4_000;

  private final Variables wiring;
  private int target;
  private long askDueMicros = Long.MIN_VALUE;
  private int firstByte = -1; // first byte of a position reply; −1: none

  /**
   * Wiring of a servo.
   *
   * @param channel channel of the controller
   * @param middlePulse pulse at the centre of the travel [µs]
   * @param pulsePerAngle pulse change per angle [µs/rad]
   * @param shortestPulse minimum pulse [µs]
   * @param longestPulse maximum pulse [µs]
   */
  public record Variables(
      @Variable(min = 0, max = 23, ifAbsent = 0) @Description("MAESTRO: channel of the servo.")
          int channel,
      @Variable(unit = "us", min = 500, max = 2500, ifAbsent = 1500)
          @Description("MAESTRO: pulse at the centre of the servo's travel.")
          double middlePulse,
      @Variable(unit = "us/rad", min = 10, max = 5000, ifAbsent = 636.6)
          @Description("MAESTRO: pulse change per angle; typically 500 us for 45 deg.")
          double pulsePerAngle,
      @Variable(unit = "us", min = 500, max = 1500, ifAbsent = 1000)
          @Description("MAESTRO: minimum pulse.")
          double shortestPulse,
      @Variable(unit = "us", min = 1500, max = 2500, ifAbsent = 2000)
          @Description("MAESTRO: maximum pulse.")
          double longestPulse) {}

  /** Uses the link; closing the device closes it. */
  public Maestro(ByteLink link, Variables wiring) {
    super(link);
    this.wiring = wiring;
    turn(0.0);
  }

  @Override
  protected void found(long nowMicros) {
    firstByte = -1;
    askDueMicros = Long.MIN_VALUE;
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    for (int i = 0; i < length; i++) {
      int value = bytes[i] & 0xff;
      if (firstByte < 0) {
        firstByte = value;
        continue;
      }
      double pulseUs = (firstByte | value << 8) / QUARTERS_PER_US;
      firstByte = -1;
      if (pulseUs > 0.0 && pulseUs <= LONGEST_US) { // 0: no pulses yet
        double angle = (pulseUs - wiring.middlePulse()) / wiring.pulsePerAngle();
        latest = Optional.of(new Position(nowMicros, OptionalDouble.of(angle)));
      }
    }
  }

  @Override
  protected void act(long nowMicros) {
    if (!link.isConnected()) {
      return;
    }
    write();
    if (nowMicros >= askDueMicros) {
      askDueMicros = nowMicros + ASK_EVERY_MICROS;
      firstByte = -1; // resynchronise after a truncated reply
      link.write(new byte[] {(byte) GET_POSITION, (byte) wiring.channel()});
    }
  }

  private void write() {
    link.write(
        new byte[] {
          (byte) SET_TARGET,
          (byte) wiring.channel(),
          (byte) (target & LOW_BITS),
          (byte) (target >> 7 & LOW_BITS)
        });
  }

  @Override
  public void turn(double angleRad) {
    double pulseUs = wiring.middlePulse() + wiring.pulsePerAngle() * angleRad;
    double within = Math.max(wiring.shortestPulse(), Math.min(wiring.longestPulse(), pulseUs));
    target = (int) Math.round(within * QUARTERS_PER_US);
  }

  @Override
  public void leave() {
    link.close();
  }

  /** Provider of SERVO = MAESTRO. */
  public static final class Provider extends LinkProvider<Servo> {
    public Provider() {
      super(Servo.class, Variables.class, (name, link, own) -> new Maestro(link, own), "MAESTRO");
    }
  }
}
