package org.u2sa.sim.ground;

import java.util.List;
import java.util.Optional;
import org.u2sa.sim.sensor.CompassField;

/** Plays the hazards of a run upon a vehicle. */
final class HazardPlay {
  private final GroundVehicle vehicle;
  private final List<Hazard> all;
  private final List<Hazard.GpsOutage> outages;
  private final List<Hazard.Manual> manuals;
  private final List<Hazard.RadioSilence> silences;
  private final List<Hazard.BatteryAt> batteries;
  private final List<Hazard.Push> pushes;
  private final List<Hazard.Magnetic> magnets;
  private double lastS = -1.0;

  HazardPlay(Hazards hazards, GroundVehicle vehicle, Surface surface) {
    this.vehicle = vehicle;
    all = hazards.all();
    outages = hazards.of(Hazard.GpsOutage.class);
    manuals = hazards.of(Hazard.Manual.class);
    silences = hazards.of(Hazard.RadioSilence.class);
    batteries = hazards.of(Hazard.BatteryAt.class);
    pushes = hazards.of(Hazard.Push.class);
    magnets = hazards.of(Hazard.Magnetic.class);
    vehicle.ground(hazards.on(surface));
  }

  List<Hazard> all() {
    return all;
  }

  /** Pushes and exchanges the battery, before the tick that ends now. */
  void act(double timeS) {
    if (!pushes.isEmpty()) {
      double east = 0.0;
      double north = 0.0;
      double turn = 0.0;
      for (Hazard.Push push : pushes) {
        if (push.lasts(timeS)) {
          east += push.eastN();
          north += push.northN();
          turn += push.turnNm();
        }
      }
      vehicle.push(east, north, turn);
    }
    for (Hazard.BatteryAt battery : batteries) {
      if (battery.atS() > lastS && battery.atS() <= timeS) {
        vehicle.charge(battery.charge());
      }
    }
    lastS = timeS;
  }

  /**
   * Who drives: the sticks while somebody switched to manual; nobody without radio, as the
   * multiplexer falls to the side of the receiver, which gives no pulses; otherwise the board.
   */
  DriveCommand master(double timeS, double first, double second) {
    if (radioSilent(timeS)) {
      return DriveCommand.none();
    }
    return sticks(timeS).orElseGet(() -> new DriveCommand(first, second));
  }

  Optional<DriveCommand> sticks(double timeS) {
    for (Hazard.Manual manual : manuals) {
      if (manual.lasts(timeS)) {
        return Optional.of(manual.sticks());
      }
    }
    return Optional.empty();
  }

  boolean radioSilent(double timeS) {
    for (Hazard.RadioSilence silence : silences) {
      if (silence.lasts(timeS)) {
        return true;
      }
    }
    return false;
  }

  boolean gpsBlocked(double timeS) {
    for (Hazard.GpsOutage outage : outages) {
      if (outage.lasts(timeS)) {
        return true;
      }
    }
    return false;
  }

  CompassField field(double eastM, double northM, double leftA, double rightA) {
    double east = 0.0;
    double north = 0.0;
    for (Hazard.Magnetic magnet : magnets) {
      double share = magnet.share(eastM, northM);
      east += share * magnet.eastUt();
      north += share * magnet.northUt();
    }
    return new CompassField(east, north, leftA, rightA);
  }
}
