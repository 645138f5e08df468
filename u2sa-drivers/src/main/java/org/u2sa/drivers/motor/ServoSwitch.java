package org.u2sa.drivers.motor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.device.port.Servo;
import org.u2sa.drivers.link.LinkProvider;

/**
 * A servo at a Maestro as the output of a switched payload: shortest pulse at 0 %, longest at 100
 * %.
 */
public final class ServoSwitch implements SwitchOutput {
  private static final double FULL_PERCENT = 100.0;

  private final Servo servo;
  private final double zeroRad;
  private final double fullRad;
  private boolean isSet;
  private Optional<Level> latest = Optional.empty();

  /**
   * @param zeroRad angle at 0 % [rad]
   * @param fullRad angle at 100 % [rad]
   */
  ServoSwitch(Servo servo, double zeroRad, double fullRad) {
    this.servo = servo;
    this.zeroRad = zeroRad;
    this.fullRad = fullRad;
  }

  @Override
  public void set(double percent) {
    isSet = true;
    servo.turn(zeroRad + percent / FULL_PERCENT * (fullRad - zeroRad));
  }

  @Override
  public Optional<Level> read(long nowMicros) {
    if (!isSet) { // the servo must not move on its own
      latest = isConnected() ? Optional.of(new Level(nowMicros, OptionalDouble.empty())) : latest;
      return latest;
    }
    latest = servo.read(nowMicros).map(this::level);
    return latest;
  }

  private Level level(Servo.Position position) {
    OptionalDouble angle = position.angleRad();
    return new Level(
        position.measuredAtMicros(),
        angle.isEmpty()
            ? OptionalDouble.empty()
            : OptionalDouble.of(
                FULL_PERCENT * (angle.getAsDouble() - zeroRad) / (fullRad - zeroRad)));
  }

  @Override
  public boolean isConnected() {
    return servo.isConnected();
  }

  @Override
  public int connections() {
    return servo.connections();
  }

  @Override
  public String trouble() {
    return servo.trouble();
  }

  @Override
  public void leave() {
    servo.leave();
  }

  @Override
  public void close() {
    servo.close();
  }

  /** Provider of OUTPUT = MAESTRO. */
  public static final class Provider extends LinkProvider<SwitchOutput> {
    public Provider() {
      super(
          SwitchOutput.class,
          Maestro.Variables.class,
          (name, link, own) ->
              new ServoSwitch(
                  new Maestro(link, own),
                  (own.shortestPulse() - own.middlePulse()) / own.pulsePerAngle(),
                  (own.longestPulse() - own.middlePulse()) / own.pulsePerAngle()),
          "MAESTRO");
    }
  }
}
