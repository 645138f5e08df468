package org.u2sa.sim.file;

import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.World;

/** The Cessna 172P of {@link Cessna172}, standing with its engine running or stopped. */
record Cessna172Model(Body body, boolean engineRunning) implements VehicleModel {
  private static final List<String> BOTH_WAYS = List.of("AILERON", "ELEVATOR", "RUDDER");

  private static final double LIGHTEST_KG = 650.0; // empty
  private static final double HEAVIEST_KG = 1_300.0;

  private enum Engine {
    RUNNING,
    STOPPED
  }

  static Cessna172Model read(FileElement file, Body body) {
    if (!(body.massKg() >= LIGHTEST_KG && body.massKg() <= HEAVIEST_KG)) {
      throw file.xml()
          .error(
              String.format(
                  Locale.ROOT,
                  "the body's mass is %s kg; expected %.0f…%.0f kg",
                  body.massKg(),
                  LIGHTEST_KG,
                  HEAVIEST_KG));
    }
    AircraftParts.requireAtGravityCentre(file, body);
    return new Cessna172Model(body, file.choice("engine", Engine.class) == Engine.RUNNING);
  }

  @Override
  public Medium medium() {
    return Medium.AIR;
  }

  @Override
  public boolean isSteppedByOwner() {
    return true;
  }

  @Override
  public List<String> actuators() {
    return Cessna172.CONTROLS;
  }

  @Override
  public double lowest(String actuator) {
    return BOTH_WAYS.contains(actuator) ? -1.0 : 0.0;
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    Geodetic origin = world.plane().origin();
    Geodetic place =
        start.equals(Point.ORIGIN) ? origin : world.plane().at(start.x(), start.y(), start.z());
    return Cessna172.onRunway(
        new RunwayStart(place.longitudeDeg(), place.latitudeDeg(), place.altitudeM(), headingRad),
        world,
        engineRunning,
        body.massKg(),
        body.inertia(),
        body.footprint());
  }
}
