package org.u2sa.sim.performance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.performance.OpenLoop.End;
import org.u2sa.sim.performance.OpenLoop.Motion;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

class OpenLoopTest {
  /** A vehicle whose speed ahead and pitch are given over time. */
  private record Scripted(DoubleUnaryOperator speed, DoubleUnaryOperator pitch, double[] clock)
      implements SimulatedVehicle {
    @Override
    public List<String> actuators() {
      return List.of();
    }

    @Override
    public void command(String actuator, double value) {
      throw new IllegalArgumentException(actuator);
    }

    @Override
    public void step(double dtS) {
      clock[0] += dtS;
    }

    @Override
    public VehicleTruth truth() {
      Attitude attitude = new Attitude(0.0, pitch.applyAsDouble(clock[0]), 0.0);
      Point ned = attitude.nedFromFrd().times(Point.of(speed.applyAsDouble(clock[0]), 0.0, 0.0));
      Point velocity = Point.of(ned.y(), ned.x(), -ned.z());
      return new VehicleTruth(
          clock[0], Point.ORIGIN, attitude, velocity, Point.ORIGIN, Point.ORIGIN);
    }

    @Override
    public Footprint footprint() {
      return Footprint.rectangle(0.5, 0.5, 0.5, 0.0, 0.5);
    }

    @Override
    public World world() {
      return World.at(new Geodetic(0.0, 0.0, 0.0));
    }
  }

  private static Motion run(DoubleUnaryOperator speed, DoubleUnaryOperator pitch) {
    return OpenLoop.run(new Scripted(speed, pitch, new double[1]), MotionAxis.SURGE, 1.0);
  }

  @Test
  void run_hullThatTakesMinutes_endsAtItsFinalSpeed() {
    Motion motion = run(t -> 3.0 * (1.0 - Math.exp(-t / 400.0)), t -> 0.0);

    assertThat(motion.end()).isEqualTo(End.STEADY);
    assertThat(motion.last()).isCloseTo(3.0, within(0.01));
    assertThat(motion.peak()).isCloseTo(3.0 / 400.0, within(1e-5));
  }

  @Test
  void run_speedThatOvershoots_isTheSteadyOne() {
    assertThat(run(t -> 2.0 + 3.0 * t * Math.exp(-t), t -> 0.0).last())
        .isCloseTo(2.0, within(0.01));
  }

  @Test
  void run_speedThatSwings_oscillates() {
    assertThat(run(t -> 2.0 + 0.5 * Math.sin(t), t -> 0.0).end()).isEqualTo(End.OSCILLATING);
  }

  @Test
  void run_speedThatGrowsForHours_isChanging() {
    assertThat(run(t -> 1e-4 * t, t -> 0.0).end()).isEqualTo(End.CHANGING);
  }

  @Test
  void run_vehicleThatPitchesOver_endsThere() {
    Motion motion = run(t -> Math.min(1.0, t), t -> 0.3 * t);

    assertThat(motion.end()).isEqualTo(End.OVERTURNED);
    assertThat(motion.last()).isCloseTo(1.0, within(1e-9));
  }

  @Test
  void run_speedBeyondAllNumbers_diverges() {
    assertThat(run(t -> Math.exp(t * t), t -> 0.0).end()).isEqualTo(End.DIVERGED);
    assertThat(run(t -> t < 3.0 ? 1.0 : Double.NaN, t -> 0.0).end()).isEqualTo(End.DIVERGED);
  }
}
