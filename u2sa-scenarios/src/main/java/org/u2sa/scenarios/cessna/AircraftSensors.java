package org.u2sa.scenarios.cessna;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.run.SimulatedSensors;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** Devices for the sensors that a system file adds to the embedded aircraft. */
final class AircraftSensors {
  private AircraftSensors() {}

  /**
   * Registers the sensors with the launcher, beside the Simulator whose aircraft carries them.
   *
   * @param start position of the aircraft until the Simulator exists
   * @param surroundings objects; moving ones report their position by transponder
   */
  static void attach(
      LaunchOptions launch, RunwayStart start, long seed, Surroundings surroundings) {
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
    Supplier<SimulatedSensors.Moment> now =
        () -> aircraft.get().map(AircraftSensors::moment).orElse(parked);
    new SimulatedSensors(seed, plane, now)
        .receiver(GpsParameters.aviation())
        .traffic(() -> traffic(surroundings, plane, now.get().vehicle().timeS()))
        .attach(launch);
  }

  private static List<SimulatedTraffic.Other> traffic(
      Surroundings surroundings, LocalPlane plane, double timeS) {
    return surroundings.objects().stream()
        .filter(Surroundings::moves)
        .map(
            object -> {
              Point here = place(object, plane, timeS);
              Point soon = place(object, plane, timeS + 1.0);
              return new SimulatedTraffic.Other(
                  object.uid(), object.objectType(), here, soon.minus(here));
            })
        .toList();
  }

  private static Point place(ObjectDescription object, LocalPlane plane, double timeS) {
    Point centre = Surroundings.centreAfter(object, timeS);
    return plane.point(Surroundings.onEarth(object, centre, plane.origin()));
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
