package org.u2sa.sim.file;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.jsbsim.JsbsimAircraft;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** An aircraft in the file format of JSBSim, standing on its wheels or on a catapult. */
record JsbsimModel(JsbsimAircraft aircraft, Optional<Catapult> catapult, Footprint footprint)
    implements VehicleModel {
  private static final double LARGEST = 1e12;

  static JsbsimModel read(FileElement file, Body body) {
    Path vehicle = Path.of(file.xml().origin()).toAbsolutePath();
    Path aircraft = vehicle.resolveSibling(file.text("file"));
    Map<String, Double> properties = new HashMap<>();
    for (FileElement each : file.parts("property", "name")) {
      properties.put(each.xml().attribute("name"), each.number("value", "1", -LARGEST, LARGEST));
      each.end();
    }
    return new JsbsimModel(
        JsbsimAircraft.read(aircraft, properties), AircraftParts.catapult(file), body.footprint());
  }

  @Override
  public Medium medium() {
    return Medium.AIR;
  }

  @Override
  public List<String> actuators() {
    return aircraft.actuators();
  }

  @Override
  public double lowest(String actuator) {
    return aircraft.lowest(actuator);
  }

  @Override
  public OptionalDouble travelRad(String actuator) {
    return aircraft.travelRad(actuator);
  }

  @Override
  public OptionalDouble massKg() {
    return OptionalDouble.of(aircraft.massKg());
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    if (catapult.isEmpty()) {
      return aircraft.standing(footprint, world, start, headingRad).aircraft();
    }
    Point up = Point.of(0.0, 0.0, catapult.get().heightM());
    UnmannedAircraft waiting =
        aircraft.flight(Map.of(), footprint, world, start.plus(up), headingRad).aircraft();
    waiting.waitOn(catapult.get());
    return waiting;
  }
}
