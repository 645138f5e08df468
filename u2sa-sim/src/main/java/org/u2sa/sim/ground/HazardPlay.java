package org.u2sa.sim.ground;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/** Applies the hazards of a run to a vehicle. */
final class HazardPlay {
  private final GroundVehicle vehicle;
  private final List<DrivingHazard> all;
  private final List<DrivingHazard.BatteryAt> batteries;
  private final List<DrivingHazard.Push> pushes;
  private final List<DrivingHazard.Magnetic> magnets;
  private final List<DrivingHazard.Multipath> reflections;
  private double lastS = -1.0;

  HazardPlay(Hazards hazards, GroundVehicle vehicle, World world) {
    this.vehicle = vehicle;
    all = hazards.all();
    batteries = hazards.of(DrivingHazard.BatteryAt.class);
    pushes = hazards.of(DrivingHazard.Push.class);
    magnets = hazards.of(DrivingHazard.Magnetic.class);
    reflections = hazards.of(DrivingHazard.Multipath.class);
    vehicle.enter(world.with(hazards.on(world.surface())));
  }

  /** Applies forces and battery changes before the tick that ends now. */
  void act(double timeS) {
    if (!pushes.isEmpty()) {
      double east = 0.0;
      double north = 0.0;
      double turn = 0.0;
      for (DrivingHazard.Push push : pushes) {
        if (push.lasts(timeS)) {
          east += push.eastN();
          north += push.northN();
          turn += push.turnNm();
        }
      }
      vehicle.push(east, north, turn);
    }
    for (DrivingHazard.BatteryAt battery : batteries) {
      if (battery.atS() > lastS && battery.atS() <= timeS) {
        vehicle.charge(battery.charge());
      }
    }
    lastS = timeS;
  }

  /**
   * Selects the source of motor commands: the sticks in manual override; none without radio,
   * because the multiplexer falls back to the receiver, which sends no pulses; otherwise the board.
   */
  DriveCommand master(double timeS, double first, double second) {
    if (radioSilent(timeS)) {
      return DriveCommand.none();
    }
    return sticks(timeS).orElseGet(() -> new DriveCommand(first, second));
  }

  Optional<DriveCommand> sticks(double timeS) {
    return now(DrivingHazard.Manual.class, timeS).map(DrivingHazard.Manual::sticks);
  }

  boolean radioSilent(double timeS) {
    return now(DrivingHazard.RadioSilence.class, timeS).isPresent();
  }

  boolean gpsBlocked(double timeS) {
    return now(DrivingHazard.GpsOutage.class, timeS).isPresent();
  }

  /** Position seen by the receiver, including multipath but not its own errors. */
  VehicleTruth received(VehicleTruth truth) {
    double east = 0.0;
    double north = 0.0;
    for (DrivingHazard.Multipath reflection : reflections) {
      if (reflection.lasts(truth.timeS())) {
        east += reflection.eastM();
        north += reflection.northM();
      }
    }
    return east == 0.0 && north == 0.0
        ? truth
        : new VehicleTruth(
            truth.timeS(),
            truth.position().plus(Point.of(east, north, 0.0)),
            truth.attitude(),
            truth.velocity(),
            truth.rates(),
            truth.acceleration());
  }

  private <T extends DrivingHazard.Window> Optional<T> now(Class<T> kind, double timeS) {
    for (DrivingHazard hazard : all) { // a loop, for speed: called on every tick
      if (kind.isInstance(hazard) && kind.cast(hazard).lasts(timeS)) {
        return Optional.of(kind.cast(hazard));
      }
    }
    return Optional.empty();
  }

  CompassModel.Disturbance field(double eastM, double northM, double leftA, double rightA) {
    double east = 0.0;
    double north = 0.0;
    for (DrivingHazard.Magnetic magnet : magnets) {
      double share = magnet.share(eastM, northM);
      east += share * magnet.eastUt();
      north += share * magnet.northUt();
    }
    return new CompassModel.Disturbance(east, north, leftA, rightA);
  }
}
