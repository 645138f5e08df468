package org.u2sa.drivers.motor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Thruster;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * A VESC motor controller driving a propeller, on USB or a UART: duty cycles out, values in
 * (vedderb/bldc, {@code comm/commands.c}). The controller stops the motor after the time-out in its
 * application settings (factory default 1 s).
 */
public final class Vesc extends LinkedDevice<Thruster.Turning> implements Thruster {
  private static final byte GET_VALUES = 4;
  private static final byte SET_DUTY = 5;
  private static final double DUTY_PER_PERCENT = 1000.0; // 100,000 is full
  private static final long ASK_EVERY_MICROS = Clock.micros(0.1);
  private static final int VALUES_BYTES = 54; // up to the fault code; newer firmware appends fields
  private static final int INPUT_CURRENT = 9;
  private static final int ELECTRICAL_RPM = 23;
  private static final int INPUT_VOLTAGE = 27;
  private static final int FAULT = 53;
  private static final double CURRENT_STEP_A = 0.01;
  private static final double VOLTAGE_STEP_V = 0.1;

  private final VescPacket packet = new VescPacket(this::take, this::refuse);
  private final double polePairs;
  private double percent;
  private long heardMicros; // arrival time of the bytes being parsed
  private long askDueMicros = Long.MIN_VALUE;
  private int fault;

  /**
   * Uses the link; closing the device closes it.
   *
   * @param polePairs pole pairs of the motor: electrical revolutions per mechanical revolution
   */
  public Vesc(ByteLink link, int polePairs) {
    super(link);
    this.polePairs = polePairs;
  }

  @Override
  protected void found(long nowMicros) {
    packet.reset();
    askDueMicros = Long.MIN_VALUE;
    fault = 0;
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    heardMicros = nowMicros;
    packet.accept(bytes, length);
  }

  private void take(byte[] values) {
    if (values.length < VALUES_BYTES || values[0] != GET_VALUES) {
      return;
    }
    double rpm = RoboClawRequest.signed32(values, ELECTRICAL_RPM) / polePairs;
    double currentA = RoboClawRequest.signed32(values, INPUT_CURRENT) * CURRENT_STEP_A;
    double batteryV = (short) RoboClawRequest.unsigned16(values, INPUT_VOLTAGE) * VOLTAGE_STEP_V;
    if (batteryV < 0.0) {
      refuse("a supply voltage below 0 V");
      return;
    }
    fault = values[FAULT];
    latest =
        Optional.of(
            new Turning(
                heardMicros,
                OptionalDouble.of(rpm),
                OptionalDouble.empty(),
                OptionalDouble.of(currentA),
                OptionalDouble.of(batteryV)));
  }

  @Override
  protected void act(long nowMicros) {
    if (!link.isConnected()) {
      return;
    }
    link.write(duty(percent));
    if (nowMicros >= askDueMicros) {
      askDueMicros = nowMicros + ASK_EVERY_MICROS;
      link.write(VescPacket.of(GET_VALUES));
    }
  }

  private static byte[] duty(double percent) {
    int duty = (int) Math.round(percent * DUTY_PER_PERCENT);
    return VescPacket.of(
        SET_DUTY, (byte) (duty >> 24), (byte) (duty >> 16), (byte) (duty >> 8), (byte) duty);
  }

  @Override
  protected String ownTrouble() {
    return fault == 0 ? "" : "the VESC reports fault " + fault;
  }

  @Override
  public void thrust(double newPercent) {
    percent = Math.max(-100.0, Math.min(100.0, newPercent));
  }

  @Override
  public void stop(long nowMicros) {
    percent = 0.0;
    link.write(duty(0.0));
  }

  @Override
  public void leave() {
    link.close();
  }

  @Override
  public void close() {
    try {
      link.write(duty(0.0));
    } finally {
      link.close();
    }
  }

  /** Provider of THRUSTER = VESC. */
  public static final class Provider extends LinkProvider<Thruster> {
    private record Variables(
        @Variable(min = 1, max = 100, ifAbsent = 7)
            @Description(
                "VESC: pairs of magnetic poles of the motor; half the number of its magnets.")
            int polePairs) {}

    public Provider() {
      super(
          Thruster.class,
          Variables.class,
          (name, link, own) -> new Vesc(link, own.polePairs()),
          "VESC");
    }
  }
}
