import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.jsbsim.JsbsimAircraft;
import org.u2sa.sim.jsbsim.JsbsimFlight;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * Flies an aircraft of JSBSim's format for compare.py. Reads lines from standard input: {@code start
 * up u v w phi theta psi NAME=VALUE…} (m, m/s, rad, properties) and {@code step seconds
 * ACTUATOR=VALUE…}; answers each with the state as {@code NAME=VALUE …} in JSBSim's units.
 */
public final class Bridge {
  private static final double FOOT = 0.3048;
  private static final double GROUND_M = -10_000.0 * FOOT; // out of ground effect
  private static final List<String> READ =
      List.of(
          "aero/alpha-rad", "aero/alpha-deg", "aero/beta-rad", "velocities/vc-kts",
          "fcs/elevator-pos-rad", "propulsion/engine/power-hp", "propulsion/engine/propeller-rpm",
          "propulsion/engine/map-pa", "fcs/flap-pos-deg", "velocities/vt-fps");

  private final JsbsimAircraft aircraft;
  private JsbsimFlight flight;

  private Bridge(Path file) {
    aircraft = JsbsimAircraft.read(file, Map.of());
  }

  /** One argument: the aircraft's file. */
  public static void main(String[] arguments) throws IOException {
    Bridge bridge = new Bridge(Path.of(arguments[0]));
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      List<String> words = List.of(line.trim().split(" "));
      bridge.obey(words);
      System.out.println(bridge.state());
    }
  }

  private static Map<String, Double> assigned(List<String> words) {
    Map<String, Double> values = new HashMap<>();
    for (String word : words) {
      String[] sides = word.split("=");
      values.put(sides[0].replace('_', ' '), Double.parseDouble(sides[1]));
    }
    return values;
  }

  private void obey(List<String> words) {
    if (words.get(0).equals("step")) {
      assigned(words.subList(2, words.size())).forEach(this::command);
      flight.aircraft().step(Double.parseDouble(words.get(1)));
      return;
    }
    List<Double> n =
        words.subList(1, 8).stream().map(Double::parseDouble).collect(Collectors.toList());
    Map<String, Double> given = new HashMap<>();
    for (String word : words.subList(8, words.size())) {
      String[] sides = word.split("=");
      given.put(sides[0], Double.parseDouble(sides[1]));
    }
    World world = World.at(new Geodetic(0.0, 45.0, GROUND_M));
    Footprint outline = Footprint.rectangle(1.0, 1.0, 2.0, -0.5, 0.5);
    flight = aircraft.flight(given, outline, world, Point.of(0.0, 0.0, n.get(0) - GROUND_M), 0.0);
    flight
        .aircraft()
        .fly(
            new Attitude(n.get(4), n.get(5), n.get(6)), Point.of(n.get(1), n.get(2), n.get(3)));
  }

  private void command(String actuator, double value) {
    if (aircraft.actuators().contains(actuator)) {
      flight.aircraft().command(actuator, value);
    }
  }

  private String state() {
    VehicleTruth truth = flight.aircraft().truth();
    Point enu = truth.velocity();
    Point body =
        truth.attitude().nedFromFrd().transposed().times(Point.of(enu.y(), enu.x(), -enu.z()));
    Map<String, Double> values = new HashMap<>();
    READ.forEach(name -> values.put(name, flight.property(name)));
    values.put("simulation/sim-time-sec", truth.timeS());
    values.put("position/h-sl-ft", (truth.position().z() + GROUND_M) / FOOT);
    values.put("velocities/h-dot-fps", enu.z() / FOOT);
    values.put("velocities/u-fps", body.x() / FOOT);
    values.put("velocities/v-fps", body.y() / FOOT);
    values.put("velocities/w-fps", body.z() / FOOT);
    values.put("velocities/p-rad_sec", truth.rates().x());
    values.put("velocities/q-rad_sec", truth.rates().y());
    values.put("velocities/r-rad_sec", truth.rates().z());
    values.put("attitude/phi-rad", truth.attitude().phi());
    values.put("attitude/theta-rad", truth.attitude().theta());
    values.put("attitude/psi-rad", truth.attitude().psi());
    values.put("velocities/vtrue-kts", flight.property("velocities/vt-fps") * FOOT * 3.6 / 1.852);
    return values.entrySet().stream()
        .map(each -> String.format(Locale.ROOT, "%s=%.12g", each.getKey(), each.getValue()))
        .collect(Collectors.joining(" "));
  }
}
