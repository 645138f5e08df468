package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.marine.CrossFlow;
import org.u2sa.sim.marine.Fin;
import org.u2sa.sim.marine.Hull;
import org.u2sa.sim.marine.HullLift;
import org.u2sa.sim.marine.MarinePropeller;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.marine.VesselActuator;
import org.u2sa.sim.marine.VesselThruster;
import org.u2sa.sim.marine.Waterplane;
import org.u2sa.sim.marine.Windage;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * A hull with any number of thrusters, propellers and fins, on or under water, after Fossen.
 *
 * @param failures times at which thrusters fail, by name [s]; infinite for never
 */
record VesselModel(
    Hull hull,
    List<VesselActuator> parts,
    Map<String, Double> failures,
    Footprint footprint,
    Optional<Windage> windage)
    implements VehicleModel {
  private static final double LARGEST = 1e9;
  private static final double FAR_M = 1_000.0;
  private static final int MAX_ACTUATORS = 64;

  /** Whether the hull has a Munk moment. */
  private enum MunkMoment {
    /** As in potential theory, i.e. with all couplings. */
    INCLUDED,
    /** Without the couplings of added mass in pitch and yaw. */
    NONE
  }

  static VesselModel read(FileElement file, Body body) {
    Optional<Waterplane> waterplane = file.optionalPart("waterplane").map(VesselModel::waterplane);
    Optional<CrossFlow> crossFlow = file.optionalPart("crossFlow").map(VesselModel::crossFlow);
    Optional<HullLift> lift = file.optionalPart("hullLift").map(VesselModel::lift);
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
            crossFlow,
            lift,
            coefficients(file, "dragFade", "s/m"),
            !file.has("munkMoment")
                || file.choice("munkMoment", MunkMoment.class) == MunkMoment.INCLUDED);
    Optional<Windage> windage = file.optionalPart("windage").map(VesselModel::windage);
    Map<String, Double> failures = new HashMap<>();
    List<VesselActuator> actuators = actuators(file, failures);
    return new VesselModel(hull, actuators, Map.copyOf(failures), body.footprint(), windage);
  }

  private static Point coefficients(FileElement file, String name, String unit) {
    return file.vector(name, unit, 0.0, LARGEST, Point.ORIGIN);
  }

  private static Windage windage(FileElement file) {
    return file.complete(
        () ->
            new Windage(
                file.number("ahead", "kg/m", 0.0, LARGEST),
                file.number("aside", "kg/m", 0.0, LARGEST),
                file.number("turning", "kg", -LARGEST, LARGEST, 0.0),
                file.has("axes") ? file.choice("axes", Windage.Axes.class) : Windage.Axes.BODY,
                file.number("height", "m", 0.0, FAR_M, 1.0)));
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

  private static HullLift lift(FileElement file) {
    return file.complete(
        () ->
            new HullLift(
                file.positive("area", "m^2", 1e6),
                file.positive("span", "m", FAR_M),
                file.positive("parasiticDrag", "1", 100.0),
                file.positive("efficiency", "1", 10.0),
                file.positive("density", "kg/m^3", 20_000.0)));
  }

  private static List<VesselActuator> actuators(FileElement file, Map<String, Double> failures) {
    List<VesselActuator> all = new ArrayList<>();
    add(file, "thruster", each -> thruster(each, failures), all);
    add(file, "propeller", VesselModel::propeller, all);
    add(file, "fin", VesselModel::fin, all);
    boolean isDriven = all.stream().anyMatch(each -> !(each instanceof Fin));
    if (!isDriven || all.size() > MAX_ACTUATORS) {
      throw file.xml()
          .error(
              "has "
                  + all.size()
                  + " actuators; expected 1…"
                  + MAX_ACTUATORS
                  + ", with a <thruster> or <propeller>");
    }
    return List.copyOf(all);
  }

  private static void add(
      FileElement file,
      String kind,
      Function<FileElement, VesselActuator> reader,
      List<VesselActuator> all) {
    for (FileElement each : file.parts(kind, "name")) {
      VesselActuator actuator = reader.apply(each);
      if (all.stream().anyMatch(other -> other.name().equals(actuator.name()))) {
        throw each.xml().error("name \"" + actuator.name() + "\" is already an actuator's");
      }
      all.add(actuator);
    }
  }

  private static VesselActuator thruster(FileElement file, Map<String, Double> failures) {
    Point direction = file.direction("direction");
    String name = file.xml().attribute("name");
    failures.put(name, file.number("failsAt", "s", 0.0, LARGEST, Double.POSITIVE_INFINITY));
    return file.complete(
        () ->
            new VesselThruster(
                name,
                file.vector("position", "m", -FAR_M, FAR_M),
                direction,
                file.positive("forward", "N", LARGEST),
                file.number("reverse", "N", 0.0, LARGEST),
                file.number("deadBand", "1", 0.0, 0.9),
                file.number("exponent", "1", 0.5, 4.0),
                file.number("lag", "s", 0.02, 100.0),
                file.number("power", "W", 0.0, LARGEST, 0.0)));
  }

  private static VesselActuator propeller(FileElement file) {
    Point direction = file.direction("direction");
    double[] thrust = line(file, "thrust");
    double[] torque = line(file, "torque");
    return file.complete(
        () ->
            new MarinePropeller(
                file.xml().attribute("name"),
                file.vector("position", "m", -FAR_M, FAR_M),
                direction,
                file.positive("diameter", "m", 100.0),
                thrust[0],
                thrust[1],
                torque[0],
                torque[1],
                file.number("wake", "1", 0.0, 0.9),
                file.number("deduction", "1", 0.0, 0.9),
                file.positive("fullSpeed", "rad/s", 1e5) / (2.0 * Math.PI),
                file.positive("density", "kg/m^3", 20_000.0),
                file.number("lag", "s", 0.02, 100.0),
                file.number("power", "W", 0.0, LARGEST, 0.0)));
  }

  /** Value at 0, and slope. */
  private static double[] line(FileElement file, String name) {
    List<Double> each = file.numbers(name, "1", -100.0, 100.0, 2);
    if (each.size() != 2) {
      throw file.xml().error(name + ": expected two numbers, at J = 0 and by J");
    }
    return new double[] {each.get(0), each.get(1)};
  }

  private static VesselActuator fin(FileElement file) {
    Point direction = file.direction("direction");
    return file.complete(
        () ->
            new Fin(
                file.xml().attribute("name"),
                file.vector("position", "m", -FAR_M, FAR_M),
                direction,
                file.positive("area", "m^2", 1e6),
                file.positive("liftSlope", "1", 100.0),
                file.positive("travel", "rad", Math.PI / 2.0),
                file.positive("density", "kg/m^3", 20_000.0),
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
    return parts.stream().map(VesselActuator::name).toList();
  }

  @Override
  public double failsAtS(String actuator) {
    return failures.getOrDefault(actuator, Double.POSITIVE_INFINITY);
  }

  @Override
  public OptionalDouble travelRad(String actuator) {
    return parts.stream()
        .filter(each -> each instanceof Fin && each.name().equals(actuator))
        .mapToDouble(each -> ((Fin) each).travelRad())
        .findFirst();
  }

  @Override
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    Vessel vessel = new Vessel(hull, parts, footprint, world, start, headingRad).moored();
    windage.ifPresent(vessel::inWind);
    return vessel;
  }
}
