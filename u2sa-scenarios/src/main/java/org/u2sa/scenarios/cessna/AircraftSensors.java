package org.u2sa.scenarios.cessna;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.SimulatedSensors;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** Devices for the sensors that a system file adds to the embedded aircraft. */
final class AircraftSensors {
  private AircraftSensors() {}

  /**
   * Has the launcher make them, beside the Simulator whose aircraft carries them.
   *
   * @param start where the aircraft stands until the Simulator is made
   */
  static void attach(LaunchOptions launch, RunwayStart start, long seed) {
    AtomicReference<Optional<Cessna172>> aircraft = new AtomicReference<>(Optional.empty());
    launch.making(
        Simulator.class,
        context -> {
          Simulator simulator = new Simulator(context);
          aircraft.set(simulator.embedded());
          return simulator;
        });
    SimulatedSensors.Moment parked =
        new SimulatedSensors.Moment(
            new VehicleTruth(
                0.0,
                Point.ORIGIN,
                new Attitude(0.0, 0.0, start.headingRad()),
                Point.ORIGIN,
                Point.ORIGIN,
                Point.ORIGIN),
            Point.ORIGIN);
    LocalPlane plane =
        new LocalPlane(new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.elevationM()));
    new SimulatedSensors(
            seed, plane, () -> aircraft.get().map(AircraftSensors::moment).orElse(parked))
        .receiver(GpsParameters.aviation())
        .attach(launch);
  }

  private static SimulatedSensors.Moment moment(Cessna172 aircraft) {
    AircraftMotion motion = aircraft.state();
    VehicleTruth truth = aircraft.truth();
    double alongPlaneMps = motion.trueAirspeedMps() * StrictMath.cos(motion.sideslipRad());
    Point throughAir = // forward, left, down
        Point.of(
            alongPlaneMps * StrictMath.cos(motion.angleOfAttackRad()),
            -motion.trueAirspeedMps() * StrictMath.sin(motion.sideslipRad()),
            alongPlaneMps * StrictMath.sin(motion.angleOfAttackRad()));
    Point ned = truth.attitude().nedOf(throughAir);
    return new SimulatedSensors.Moment(
        truth, truth.velocity().minus(Point.of(ned.y(), ned.x(), -ned.z())));
  }
}
