package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.flight.LandingLeg;
import org.u2sa.sim.flight.MassProperties;
import org.u2sa.sim.flight.Rotor;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * A body carried by any number of rotors.
 *
 * @param failures time at which each rotor's motor fails [s], infinite for never
 */
record MultirotorModel(
    MassProperties mass,
    List<Rotor> rotors,
    Map<String, Double> failures,
    Point frameDrag,
    List<LandingLeg> legs,
    Footprint footprint)
    implements VehicleModel {
  private static final double FAR_M = 100.0;
  private static final Point UP = Point.of(0.0, 0.0, -1.0);
  private static final int MAX_ROTORS = 64;

  private enum Spin {
    ANTICLOCKWISE,
    CLOCKWISE
  }

  static MultirotorModel read(FileElement file, Body body) {
    List<Rotor> rotors = new ArrayList<>();
    Map<String, Double> failures = new LinkedHashMap<>();
    for (FileElement each : file.parts("rotor", "name")) {
      double failsAt = each.number("failsAt", "s", 0.0, 1e9, Double.POSITIVE_INFINITY);
      Rotor rotor = rotor(each);
      if (rotors.stream().anyMatch(other -> other.name().equals(rotor.name()))) {
        throw each.xml().error("name \"" + rotor.name() + "\" is already a rotor's");
      }
      rotors.add(rotor);
      failures.put(rotor.name(), failsAt);
    }
    if (rotors.isEmpty() || rotors.size() > MAX_ROTORS) {
      throw file.xml().error("has " + rotors.size() + " <rotor>; expected 1…" + MAX_ROTORS);
    }
    return new MultirotorModel(
        AircraftParts.mass(file, body),
        List.copyOf(rotors),
        Map.copyOf(failures),
        file.vector("frameDrag", "N s^2/m^2", 0.0, 1e3, Point.ORIGIN),
        AircraftParts.legs(file, false),
        body.footprint());
  }

  private static Rotor rotor(FileElement file) {
    double full = file.positive("fullSpeed", "rad/s", 1e5);
    double square = full * full;
    int spin = file.choice("turns", Spin.class) == Spin.ANTICLOCKWISE ? 1 : -1;
    return file.complete(
        () ->
            new Rotor(
                file.xml().attribute("name"),
                file.vector("position", "m", -FAR_M, FAR_M),
                file.direction("axis", UP),
                spin,
                file.positive("fullThrust", "N", 1e6) / square,
                file.number("fullTorque", "N m", 0.0, 1e6) / square,
                file.number("drag", "N s^2/m", 0.0, 1.0, 0.0),
                file.number("inflow", "N s^2/m", 0.0, 1.0, 0.0),
                file.number("lift", "N s^2/m^2", 0.0, 1.0, 0.0),
                full,
                file.number("lag", "s", 0.002, 10.0)));
  }

  @Override
  public Medium medium() {
    return Medium.AIR;
  }

  @Override
  public List<String> actuators() {
    return rotors.stream().map(Rotor::name).toList();
  }

  @Override
  public double failsAtS(String actuator) {
    return failures.getOrDefault(actuator, Double.POSITIVE_INFINITY);
  }

  @Override
  public double lowest(String actuator) {
    return 0.0;
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    Point stands = Point.of(0.0, 0.0, AircraftParts.standsM(legs));
    return UnmannedAircraft.multirotor(
        mass, rotors, frameDrag, legs, footprint, world, start.plus(stands), headingRad);
  }
}
