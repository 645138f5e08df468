package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/** Reads the plugins of a world of VRX: task, goals, gates, wind, waves, and the buoys around. */
final class VrxWorldReader {
  private static final double LARGEST = 1e7;
  private static final Pattern PARAMETER =
      Pattern.compile("key: \"(\\w+)\".*?double_value: ([-+.0-9eE]+)", Pattern.DOTALL);

  private static final int MAX_WAYPOINTS = 9; // VRX has five; all orders of them are tried
  private static final double FULL_LATITUDE_DEG = 90.0;

  private final Path file;
  private final XmlElement world;
  private final VrxBuoys buoys;

  private VrxWorldReader(Path file) {
    this.file = file;
    XmlElement root = XmlReader.read(file, "sdf");
    world = required(root, "world");
    buoys = new VrxBuoys(file);
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
                        "has no task that this demo runs; expected a StationkeepingScoringPlugin, WayfindingScoringPlugin or NavigationScoringPlugin"));
    XmlElement scoring = plugin(task.plugin()).orElseThrow();
    XmlElement sphere = required(world, "spherical_coordinates");
    Geodetic origin =
        new Geodetic(
            number(sphere, "longitude_deg"),
            latitude(required(sphere, "latitude_deg"), number(sphere, "latitude_deg")),
            0.0);
    world.children("include").forEach(buoys::include);
    return new VrxWorld(
        file,
        task,
        origin,
        plugin("USVWind").map(this::wind).orElse(new VrxWorld.Breeze(0.0, 0.0, 0.0, 1.0)),
        waves(),
        new VrxWorld.Times(
            positive(scoring, "ready_state_duration"), positive(scoring, "running_state_duration")),
        goals(task, scoring),
        task == VrxTask.PATH ? gates(required(scoring, "gates")) : List.of(),
        buoys.all());
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
   * Waves as the world's publisher announces them: three components a = g √(2 S(ω) Δω) at ω_p/1.1,
   * ω_p and 1.1 ω_p, with S of Pierson and Moskowitz, α = 0.0081 (VRX, Wavefield.cc).
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
      poses.add(required(scoring, "goal_pose"));
    } else if (task == VrxTask.WAYFINDING) {
      required(scoring, "waypoints")
          .children("waypoint")
          .forEach(each -> poses.add(required(each, "pose")));
      if (poses.isEmpty() || poses.size() > MAX_WAYPOINTS) {
        throw required(scoring, "waypoints")
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
              marker(required(gate, "left_marker")), marker(required(gate, "right_marker"))));
    }
    if (gates.isEmpty()) {
      throw element.error("lacks <gate>");
    }
    return gates;
  }

  private Point marker(XmlElement name) {
    return buoys
        .place(name.text().trim())
        .orElseThrow(
            () ->
                name.error(
                    "\""
                        + name.text()
                        + "\": no such marker; expected the name of an <include> of the world or of its course in ../models"));
  }

  static XmlElement required(XmlElement parent, String name) {
    return parent.child(name).orElseThrow(() -> parent.error("lacks <" + name + ">"));
  }

  private static double number(XmlElement parent, String name) {
    return numbers(required(parent, name), 1)[0];
  }

  private static double positive(XmlElement parent, String name) {
    double seconds = number(parent, name);
    if (!(seconds > 0.0)) {
      throw required(parent, name).error(seconds + " s: expected above 0");
    }
    return seconds;
  }

  private static double latitude(XmlElement element, double degrees) {
    if (!(Math.abs(degrees) <= FULL_LATITUDE_DEG)) {
      throw element.error(degrees + " deg: expected a latitude of -90 to 90");
    }
    return degrees;
  }

  private static double parsed(XmlElement element, String word) {
    double number;
    try {
      number = Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw element.error("\"" + word + "\" is not a number", e);
    }
    if (!(Math.abs(number) <= LARGEST)) {
      throw element.error("\"" + word + "\": expected a number of at most 10,000,000");
    }
    return number;
  }

  static double[] numbers(XmlElement element, int count) {
    String[] words = element.text().trim().split("\\s+");
    if (words.length < count) {
      throw element.error(
          String.format(Locale.ROOT, "\"%s\": expected %d numbers", element.text(), count));
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = parsed(element, words[i]);
    }
    return numbers;
  }
}
