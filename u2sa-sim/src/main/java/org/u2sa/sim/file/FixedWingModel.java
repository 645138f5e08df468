package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.ControlSurface;
import org.u2sa.sim.flight.ElectricPropeller;
import org.u2sa.sim.flight.LandingLeg;
import org.u2sa.sim.flight.MassProperties;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.flight.WingCoefficients;
import org.u2sa.sim.flight.WingCoefficients.Lateral;
import org.u2sa.sim.flight.WingCoefficients.Longitudinal;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** A small aeroplane defined by its coefficients, after Beard and McLain, with one propeller. */
record FixedWingModel(
    MassProperties mass,
    WingCoefficients wing,
    List<ControlSurface> surfaces,
    ElectricPropeller propeller,
    List<LandingLeg> legs,
    Optional<Catapult> catapult,
    Footprint footprint)
    implements VehicleModel {
  private static final double LARGEST = 1e3;
  private static final int MAX_SURFACES = 32;

  static FixedWingModel read(FileElement file, Body body) {
    List<LandingLeg> legs = AircraftParts.legs(file, true);
    Optional<Catapult> catapult = AircraftParts.catapult(file);
    if (legs.isEmpty() && catapult.isEmpty()) {
      throw file.xml().error("has neither <skid>, <wheel> nor <catapult>; expected one");
    }
    ElectricPropeller propeller =
        propeller(
            file.optionalPart("propeller", "name")
                .orElseThrow(() -> file.xml().error("lacks <propeller>")));
    return new FixedWingModel(
        AircraftParts.mass(file, body),
        wing(file),
        surfaces(file, propeller.name()),
        propeller,
        legs,
        catapult,
        body.footprint());
  }

  private static WingCoefficients wing(FileElement file) {
    return file.made(
        () ->
            new WingCoefficients(
                file.positive("area", "m^2", 1e4),
                file.positive("span", "m", 1e3),
                file.positive("chord", "m", 1e3),
                file.number("efficiency", "1", 0.1, 1.5),
                file.number("stallAngle", "rad", 0.05, 1.5),
                file.number("stallSharpness", "1", 1.0, 1_000.0, 50.0),
                longitudinal(file.part("liftForce")),
                file.number("parasiticDrag", "1", 0.0, LARGEST),
                file.number("dragByPitchRate", "1", -LARGEST, LARGEST, 0.0),
                file.number("dragByElevator", "1", -LARGEST, LARGEST, 0.0),
                longitudinal(file.part("pitchMoment")),
                lateral(file.part("sideForce")),
                lateral(file.part("rollMoment")),
                lateral(file.part("yawMoment"))));
  }

  private static double coefficient(FileElement file, String name) {
    return file.number(name, "1", -LARGEST, LARGEST, 0.0);
  }

  private static Longitudinal longitudinal(FileElement file) {
    Longitudinal made =
        new Longitudinal(
            coefficient(file, "zero"),
            coefficient(file, "alpha"),
            coefficient(file, "pitchRate"),
            coefficient(file, "elevator"));
    file.end();
    return made;
  }

  private static Lateral lateral(FileElement file) {
    Lateral made =
        new Lateral(
            coefficient(file, "zero"),
            coefficient(file, "beta"),
            coefficient(file, "rollRate"),
            coefficient(file, "yawRate"),
            coefficient(file, "aileron"),
            coefficient(file, "rudder"));
    file.end();
    return made;
  }

  private static List<ControlSurface> surfaces(FileElement file, String taken) {
    List<ControlSurface> all = new ArrayList<>();
    for (FileElement each : file.parts("surface", "name")) {
      ControlSurface surface =
          each.made(
              () ->
                  new ControlSurface(
                      each.xml().attribute("name"),
                      each.number("travel", "rad", 0.001, Math.PI / 2.0),
                      each.number("lag", "s", 0.005, 10.0),
                      each.number("elevator", "1", -1.0, 1.0, 0.0),
                      each.number("aileron", "1", -1.0, 1.0, 0.0),
                      each.number("rudder", "1", -1.0, 1.0, 0.0)));
      each.end();
      if (surface.name().equals(taken)
          || all.stream().anyMatch(other -> other.name().equals(surface.name()))) {
        throw each.xml().error("name \"" + surface.name() + "\" is already an actuator's");
      }
      all.add(surface);
    }
    if (all.isEmpty() || all.size() > MAX_SURFACES) {
      throw file.xml().error("has " + all.size() + " <surface>; expected 1…" + MAX_SURFACES);
    }
    return List.copyOf(all);
  }

  private static ElectricPropeller propeller(FileElement file) {
    return file.complete(
        () ->
            new ElectricPropeller(
                file.xml().attribute("name"),
                file.positive("diameter", "m", 100.0),
                quadratic(file, "thrust"),
                quadratic(file, "torque"),
                file.positive("backEmf", "V s/rad", 100.0),
                file.positive("resistance", "Ohm", 1e3),
                file.number("idleCurrent", "A", 0.0, 1e3),
                file.positive("voltage", "V", 1e4),
                file.number("lag", "s", 0.005, 10.0)));
  }

  private static ElectricPropeller.Quadratic quadratic(FileElement file, String name) {
    Point three = file.vector(name, "1", -LARGEST, LARGEST);
    return new ElectricPropeller.Quadratic(three.x(), three.y(), three.z());
  }

  @Override
  public Medium medium() {
    return Medium.AIR;
  }

  @Override
  public List<String> actuators() {
    List<String> names = new ArrayList<>();
    surfaces.forEach(each -> names.add(each.name()));
    names.add(propeller.name());
    return List.copyOf(names);
  }

  @Override
  public double lowest(String actuator) {
    return actuator.equals(propeller.name()) ? 0.0 : -1.0;
  }

  @Override
  public OptionalDouble travelRad(String actuator) {
    return surfaces.stream()
        .filter(each -> each.name().equals(actuator))
        .mapToDouble(ControlSurface::travelRad)
        .findFirst();
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    double up = catapult.map(Catapult::heightM).orElse(AircraftParts.standsM(legs));
    UnmannedAircraft aircraft =
        UnmannedAircraft.fixedWing(
            mass,
            wing,
            surfaces,
            propeller,
            legs,
            footprint,
            world,
            start.plus(Point.of(0.0, 0.0, up)),
            headingRad);
    catapult.ifPresent(aircraft::waitOn);
    return aircraft;
  }
}
