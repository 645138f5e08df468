package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.device.Thruster;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * A propeller whose speed follows its command late, and not at all near 0; it can be weakened and
 * broken. The vehicle asks it for {@link #thrustN}.
 */
public final class SimulatedThruster extends SimulatedDevice<Thruster.Turning> implements Thruster {
  private static final double MICROS_PER_S = 1e6;
  private static final double FULL_PERCENT = 100.0;

  private final Propeller propeller;
  private final Random noise;
  private final long timeoutMicros;
  private double wantedPercent; // told to the device at the next read
  private double percent; // that the motor has; guarded by this, as all below
  private long untilMicros = Long.MIN_VALUE;
  private long atMicros = Long.MIN_VALUE;
  private double rpm;
  private double strength = 1.0;

  /**
   * What it is.
   *
   * @param rateHz readings a second
   * @param fullRpm speed at 100 % [1/min]
   * @param deadbandPercent smaller commands leave it standing [%]
   * @param lagS time constant of the speed [s]
   * @param fullThrustN forward at 100 % [N]
   * @param reverseThrustN backwards at −100 %, positive [N]
   * @param fullCurrentA at 100 % [A]
   * @param batteryV voltage of its battery [V]
   * @param timeoutS after which it stops without being told to go on [s]
   * @param rpmSigma standard deviation of a measured speed [1/min]
   */
  public record Propeller(
      double rateHz,
      double fullRpm,
      double deadbandPercent,
      double lagS,
      double fullThrustN,
      double reverseThrustN,
      double fullCurrentA,
      double batteryV,
      double timeoutS,
      double rpmSigma) {
    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Propeller {
      Arguments.requirePositive("full speed", fullRpm);
      Arguments.requireInside("deadband", deadbandPercent, 0.0, 99.0);
      Arguments.requirePositive("lag", lagS);
      Arguments.requirePositive("full thrust", fullThrustN);
      Arguments.requirePositive("reverse thrust", reverseThrustN);
      Arguments.requireInside("full current", fullCurrentA, 0.0, 10_000.0);
      Arguments.requireInside("battery voltage", batteryV, 0.0, 1_000.0);
      Arguments.requirePositive("time-out", timeoutS);
      Arguments.requireInside("noise of the speed", rpmSigma, 0.0, fullRpm);
    }

    /**
     * Blue Robotics' T200 at 16 V by its data sheet: 5.25 and 4.1 kgf, 24 A, ±25 of 400 µs without
     * motion. Its lag and top speed are typical of such propellers, not from the sheet.
     */
    public static Propeller t200() {
      return new Propeller(20.0, 3_700.0, 6.25, 0.1, 51.5, 40.2, 24.0, 16.0, 0.5, 5.0);
    }
  }

  /** Takes the stream {@code name}. */
  public SimulatedThruster(Propeller propeller, NoiseStreams streams, String name) {
    super(propeller.rateHz(), 0.0);
    this.propeller = propeller;
    noise = streams.of(name);
    timeoutMicros = Math.round(propeller.timeoutS() * MICROS_PER_S);
  }

  /**
   * How hard it pushes, forward positive [N], at a moment of the run's clock. Safe from any thread.
   */
  public synchronized double thrustN(long nowMicros) {
    advance(nowMicros);
    return pushN();
  }

  /** With T = k·n·|n| (Fossen, Handbook of Marine Craft Hydrodynamics, chapter on propulsion). */
  private double pushN() {
    double share = rpm / propeller.fullRpm();
    double fullN = rpm > 0.0 ? propeller.fullThrustN() : propeller.reverseThrustN();
    return strength * fullN * share * Math.abs(share);
  }

  /**
   * Weakens it, as weeds or a broken blade do. Safe from any thread.
   *
   * @param share of its thrust that is left, 0…1; at 0 it does not turn any more
   */
  public synchronized void weaken(double share) {
    strength = Arguments.requireInside("share of the thrust", share, 0.0, 1.0);
  }

  private void advance(long nowMicros) {
    if (atMicros == Long.MIN_VALUE) {
      atMicros = nowMicros;
    }
    relax(percent, Math.min(nowMicros, untilMicros));
    relax(0.0, nowMicros);
  }

  /** A first-order lag, exact for a constant command. */
  private void relax(double commandPercent, long toMicros) {
    if (toMicros <= atMicros) {
      return;
    }
    boolean turns = Math.abs(commandPercent) > propeller.deadbandPercent() && strength > 0.0;
    double target = turns ? propeller.fullRpm() * commandPercent / FULL_PERCENT : 0.0;
    double passedS = (toMicros - atMicros) / MICROS_PER_S;
    rpm = target + (rpm - target) * StrictMath.exp(-passedS / propeller.lagS());
    atMicros = toMicros;
  }

  @Override
  synchronized void tell(long nowMicros) {
    advance(nowMicros);
    percent = wantedPercent;
    untilMicros = nowMicros + timeoutMicros;
  }

  @Override
  synchronized Turning measure(double timeS, long measuredAtMicros) {
    double share = Math.abs(rpm) / propeller.fullRpm();
    double measured = rpm + propeller.rpmSigma() * noise.nextGaussian();
    return new Turning(
        measuredAtMicros,
        OptionalDouble.of(measured),
        OptionalDouble.empty(),
        OptionalDouble.of(propeller.fullCurrentA() * share * share * share), // power ~ n³
        OptionalDouble.of(propeller.batteryV()));
  }

  @Override
  public void thrust(double newPercent) {
    wantedPercent = Math.max(-FULL_PERCENT, Math.min(FULL_PERCENT, newPercent));
  }

  @Override
  public synchronized void stop(long nowMicros) {
    wantedPercent = 0.0;
    if (isConnected()) {
      tell(nowMicros);
    }
  }

  @Override
  public void leave() {
    // it turns on until the time-out
  }

  @Override
  public synchronized void close() {
    wantedPercent = 0.0;
    if (isConnected()) {
      percent = 0.0;
    }
  }
}
