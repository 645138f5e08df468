package org.u2sa.scenarios.vrx;

import static org.u2sa.scenarios.vrx.SdfValues.latitude;
import static org.u2sa.scenarios.vrx.SdfValues.number;
import static org.u2sa.scenarios.vrx.SdfValues.numbers;
import static org.u2sa.scenarios.vrx.SdfValues.positive;
import static org.u2sa.world.sdf.SdfNumbers.parsed;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.ScriptedMover;

/** Reads the plugins of a VRX world: task, goals, gates, wind, waves, and the surrounding buoys. */
final class VrxWorldReader {
  private static final Pattern PARAMETER =
      Pattern.compile("key: \"(\\w+)\".*?double_value: ([-+.0-9eE]+)", Pattern.DOTALL);

  /**
   * Speed of animals [m/s]. VRX pushes them with forces; their masses are not in its repository.
   */
  private static final double ANIMAL_MPS = 0.3;

  private static final int MAX_WAYPOINTS = 9; // VRX has five; all orders of them are tried
  private static final double ANIMAL_RADIUS_M = 0.45;
  private static final double ANIMAL_HEIGHT_M = 0.6;

  private final Path file;
  private final XmlElement world;
  private final VrxObjects objects;

  private VrxWorldReader(Path file) {
    this.file = file;
    XmlElement root = XmlReader.read(file, "sdf");
    world = root.requiredChild("world");
    objects = new VrxObjects(file, world);
  }

  /**
   * Reads a world.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element, value and what was
   *     expected
   */
  static VrxWorld read(Path file) {
    return new VrxWorldReader(file).read();
  }

  /** The task of a world, if the demo runs it. */
  static Optional<VrxTask> task(Path file) {
    return new VrxWorldReader(file).task();
  }

  private Optional<VrxTask> task() {
    for (VrxTask each : VrxTask.values()) {
      if (plugin(each.plugin()).isPresent()) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  private VrxWorld read() {
    VrxTask task =
        task()
            .orElseThrow(
                () ->
                    world.error(
                        "has no task that this demo runs; expected one of "
                            + Arrays.stream(VrxTask.values())
                                .map(VrxTask::plugin)
                                .collect(Collectors.joining(", "))));
    XmlElement scoring = plugin(task.plugin()).orElseThrow();
    XmlElement sphere = world.requiredChild("spherical_coordinates");
    Geodetic origin =
        new Geodetic(
            number(sphere, "longitude_deg"),
            latitude(sphere.requiredChild("latitude_deg"), number(sphere, "latitude_deg")),
            0.0);
    return new VrxWorld(
        file,
        task,
        origin,
        plugin("USVWind").map(this::wind).orElse(new VrxWorld.Breeze(0.0, 0.0, 0.0, 1.0)),
        waves(),
        new VrxWorld.Times(
            positive(scoring, "ready_state_duration"), positive(scoring, "running_state_duration")),
        goals(task, scoring),
        task == VrxTask.PATH ? gates(scoring.requiredChild("gates")) : List.of(),
        objects.buoys(),
        task == VrxTask.WILDLIFE ? wildlife(scoring, new LocalPlane(origin)) : Wildlife.none(),
        task == VrxTask.DOCK ? DockingReader.read(world, objects, scoring) : Docking.none());
  }

  private Optional<XmlElement> plugin(String name) {
    return world.children("plugin").stream()
        .filter(each -> each.optionalAttribute("name").orElse("").endsWith("::" + name))
        .findFirst();
  }

  private VrxWorld.Breeze wind(XmlElement plugin) {
    double towards = VrxWorld.headingOf(Math.toRadians(number(plugin, "wind_direction")));
    return new VrxWorld.Breeze(
        number(plugin, "wind_mean_velocity"),
        towards + Math.PI,
        number(plugin, "var_wind_gain_constants"),
        positive(plugin, "var_wind_time_constants"));
  }

  /**
   * Waves by the parameters of the world's publisher: three components a = g √(2 S(ω) Δω) at
   * ω_p/1.1, ω_p and 1.1 ω_p, with the Pierson-Moskowitz spectrum S, α = 0.0081 (VRX,
   * Wavefield.cc).
   */
  private VrxWorld.Sea waves() {
    Map<String, Double> values = new HashMap<>();
    for (XmlElement plugin : world.children("plugin")) {
      for (XmlElement message : plugin.children("message")) {
        Matcher found = PARAMETER.matcher(message.text());
        while (found.find()) {
          values.put(found.group(1), parsed(message, found.group(2)));
        }
        if (!(values.getOrDefault("period", 1.0) > 0.0)) {
          throw message.error("period: expected above 0 s");
        }
      }
    }
    double gain = values.getOrDefault("gain", 0.0);
    double periodS = values.getOrDefault("period", 5.0);
    double peak = 2.0 * Math.PI / periodS;
    double[] spacing = {1.0 - 1.0 / 1.1, (1.1 - 1.0 / 1.1) / 2.0, 0.1};
    double variance = 0.0;
    for (int i = 0; i < spacing.length; i++) {
      double omega = peak * Math.pow(1.1, i - 1);
      double density =
          0.0081
              * Math.pow(Gravity.STANDARD_MPS2, 2.0)
              / Math.pow(omega, 5.0)
              * Math.exp(-1.25 * Math.pow(peak / omega, 4.0));
      variance += gain * gain * density * spacing[i] * peak; // a²/2
    }
    return new VrxWorld.Sea(
        4.0 * Math.sqrt(variance),
        periodS,
        VrxWorld.headingOf(values.getOrDefault("direction", 0.0)));
  }

  private List<VrxWorld.Goal> goals(VrxTask task, XmlElement scoring) {
    List<XmlElement> poses = new ArrayList<>();
    if (task == VrxTask.STATIONKEEPING) {
      poses.add(scoring.requiredChild("goal_pose"));
    } else if (task == VrxTask.WAYFINDING) {
      scoring
          .requiredChild("waypoints")
          .children("waypoint")
          .forEach(each -> poses.add(each.requiredChild("pose")));
      if (poses.isEmpty() || poses.size() > MAX_WAYPOINTS) {
        throw scoring
            .requiredChild("waypoints")
            .error(poses.size() + " <waypoint>; expected 1 to " + MAX_WAYPOINTS);
      }
    }
    List<VrxWorld.Goal> goals = new ArrayList<>();
    for (XmlElement pose : poses) {
      double[] n = numbers(pose, 3);
      goals.add(new VrxWorld.Goal(n[1], latitude(pose, n[0]), VrxWorld.headingOf(n[2])));
    }
    return goals;
  }

  private List<VrxWorld.Gate> gates(XmlElement element) {
    List<VrxWorld.Gate> gates = new ArrayList<>();
    for (XmlElement gate : element.children("gate")) {
      gates.add(
          new VrxWorld.Gate(
              marker(gate.requiredChild("left_marker")),
              marker(gate.requiredChild("right_marker"))));
    }
    if (gates.isEmpty()) {
      throw element.error("lacks <gate>");
    }
    return gates;
  }

  private Point marker(XmlElement name) {
    return objects.named(name).place();
  }

  private Wildlife wildlife(XmlElement scoring, LocalPlane plane) {
    List<Wildlife.Animal> animals = new ArrayList<>();
    for (XmlElement buoy : scoring.requiredChild("buoys").children("buoy")) {
      XmlElement goal = buoy.requiredChild("goal");
      Wildlife.Part part =
          switch (goal.text().trim()) {
            case "avoid" -> Wildlife.Part.AVOID;
            case "circumnavigate_clockwise" -> Wildlife.Part.CLOCKWISE;
            case "circumnavigate_counterclockwise" -> Wildlife.Part.ANTICLOCKWISE;
            default ->
                throw goal.error(
                    "\""
                        + goal.text()
                        + "\": expected avoid, circumnavigate_clockwise or circumnavigate_counterclockwise");
          };
      XmlElement named = buoy.requiredChild("name");
      String name = named.text().trim().replaceFirst("::.*", "");
      animals.add(new Wildlife.Animal(name, part, mover(objects.named(named), name, part, plane)));
    }
    return new Wildlife(
        animals, number(scoring, "engagement_distance", 10.0), number(scoring, "time_bonus", 30.0));
  }

  /** Moves to and fro between the waypoints of the model's TrajectoryFollower. */
  private static ScriptedMover mover(
      VrxObjects.Included model, String name, Wildlife.Part part, LocalPlane plane) {
    Cylinder animal = new Cylinder().radius(ANIMAL_RADIUS_M).height(ANIMAL_HEIGHT_M);
    animal.uid(name).objectType(part.species()).referenceFrame(ReferenceFrame.LOCAL_ENU);
    animal.x(model.place().x()).y(model.place().y()).z(0.0);
    List<ScriptedMover.Waypoint> way = new ArrayList<>();
    for (XmlElement plugin : model.element().children("plugin")) {
      for (XmlElement waypoints : plugin.children("waypoints")) {
        for (XmlElement each : waypoints.children("waypoint")) {
          double[] at = numbers(each, 2);
          way.add(new ScriptedMover.Waypoint(Point.of(at[0], at[1], 0.0), ANIMAL_MPS, 0.0));
        }
      }
    }
    if (way.isEmpty()) {
      way.add(new ScriptedMover.Waypoint(model.place(), ANIMAL_MPS, 0.0));
    }
    return new ScriptedMover(animal, plane, way, ScriptedMover.End.LOOP, 0.0, true, true);
  }
}
