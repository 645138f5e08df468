package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.marine.CrossFlow;
import org.u2sa.sim.marine.Hull;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.marine.VesselThruster;
import org.u2sa.sim.marine.Waterplane;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** A hull with any number of thrusters, on or under water, after Fossen. */
record VesselModel(Hull hull, List<VesselThruster> thrusters, Footprint footprint)
    implements VehicleModel {
  private static final double LARGEST = 1e9;
  private static final double FAR_M = 1_000.0;
  private static final int MAX_THRUSTERS = 64;

  static VesselModel read(FileElement file, Body body) {
    Optional<Waterplane> waterplane = file.optionalPart("waterplane").map(VesselModel::waterplane);
    Optional<CrossFlow> crossFlow = file.optionalPart("crossFlow").map(VesselModel::crossFlow);
    boolean floats = waterplane.isPresent();
    Hull hull =
        new Hull(
            body.massKg(),
            body.inertiaAboutReference(),
            coefficients(file, "addedMass", "kg"),
            coefficients(file, "addedInertia", "kg m^2"),
            coefficients(file, "drag", "N s/m"),
            coefficients(file, "angularDrag", "N m s"),
            coefficients(file, "squareDrag", "N s^2/m^2"),
            coefficients(file, "squareAngularDrag", "N m s^2"),
            body.gravityCentre(),
            floats ? Point.ORIGIN : file.vector("buoyancyCentre", "m", -FAR_M, FAR_M),
            floats ? 0.0 : file.number("buoyancy", "N", 0.0, LARGEST),
            floats ? 1.0 : file.positive("height", "m", FAR_M),
            waterplane,
            crossFlow);
    return new VesselModel(hull, thrusters(file), body.footprint());
  }

  private static Point coefficients(FileElement file, String name, String unit) {
    return file.vector(name, unit, 0.0, LARGEST, Point.ORIGIN);
  }

  private static Waterplane waterplane(FileElement file) {
    return file.complete(
        () ->
            new Waterplane(
                file.positive("heave", "N/m", LARGEST),
                file.positive("roll", "N m/rad", LARGEST),
                file.positive("pitch", "N m/rad", LARGEST),
                file.number("centreAhead", "m", -FAR_M, FAR_M, 0.0),
                file.number("ballast", "kg", 0.0, LARGEST, 0.0),
                file.vector("ballastPlace", "m", -FAR_M, FAR_M, Point.ORIGIN)));
  }

  private static CrossFlow crossFlow(FileElement file) {
    return file.complete(
        () ->
            new CrossFlow(
                file.positive("length", "m", FAR_M),
                file.positive("draught", "m", FAR_M),
                file.positive("coefficient", "1", 100.0),
                file.positive("density", "kg/m^3", 20_000.0)));
  }

  private static List<VesselThruster> thrusters(FileElement file) {
    List<VesselThruster> all = new ArrayList<>();
    for (FileElement each : file.parts("thruster", "name")) {
      VesselThruster thruster = thruster(each);
      if (all.stream().anyMatch(other -> other.name().equals(thruster.name()))) {
        throw each.xml().error("name \"" + thruster.name() + "\" is another thruster's already");
      }
      all.add(thruster);
    }
    if (all.isEmpty() || all.size() > MAX_THRUSTERS) {
      throw file.xml().error("has " + all.size() + " <thruster>; expected 1…" + MAX_THRUSTERS);
    }
    return List.copyOf(all);
  }

  private static VesselThruster thruster(FileElement file) {
    Point way = file.vector("direction", "1", -1e6, 1e6);
    double length = way.distance();
    if (!(length > 1e-6)) {
      throw file.xml().error("direction: \"" + way + "\" has no length; expected a vector");
    }
    Point direction = Point.of(way.x() / length, way.y() / length, way.z() / length);
    return file.complete(
        () ->
            new VesselThruster(
                file.xml().attribute("name"),
                file.vector("position", "m", -FAR_M, FAR_M),
                direction,
                file.positive("forward", "N", LARGEST),
                file.number("reverse", "N", 0.0, LARGEST),
                file.number("deadBand", "1", 0.0, 0.9),
                file.number("exponent", "1", 0.5, 4.0),
                file.number("lag", "s", 0.02, 100.0)));
  }

  @Override
  public Medium medium() {
    return Medium.WATER;
  }

  @Override
  public boolean isSubmerged() {
    return hull.waterplane().isEmpty();
  }

  @Override
  public List<String> actuators() {
    return thrusters.stream().map(VesselThruster::name).toList();
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    return new Vessel(hull, thrusters, footprint, world, start, headingRad).moored();
  }
}
