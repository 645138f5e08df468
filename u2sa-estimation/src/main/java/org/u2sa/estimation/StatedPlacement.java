package org.u2sa.estimation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Where the configuration of a {@link FusingStateEstimator} places the vehicle and its sensors, to
 * be compared with a simulated vehicle.
 */
public final class StatedPlacement {
  private static final double SAME_ARM_M = 0.1;
  private static final double SAME_START_M = 10.0;
  private static final double GATE = 5.0; // standard deviations

  private final String origin;
  private final FusionVariables variables;
  private final LeverArms arms;

  /** Reads it from a service's configuration. */
  public StatedPlacement(XmlConfiguration configuration) {
    origin = configuration.origin();
    variables = configuration.settings(FusionVariables.class, "").get();
    arms = new LeverArms(variables.leverArms());
  }

  /**
   * Differences from a vehicle, in words.
   *
   * @param mounted positions of its sensors, by their names: forward, right, down [m]
   * @param start where it starts
   */
  public List<String> differences(Map<String, Point> mounted, Geodetic start) {
    List<String> all = new ArrayList<>();
    new TreeMap<>(mounted)
        .forEach(
            (sensor, place) -> {
              double[] arm = {place.x(), -place.y(), place.z()};
              double[] stated = arms.of(sensor).orElseGet(() -> new double[3]);
              if (apartM(arm, stated) > SAME_ARM_M) {
                all.add(
                    String.format(
                        "%s: LEVER ARMS has %s at %s, but the vehicle has it at %s (forward left down, m)",
                        origin, sensor, words(stated), words(arm)));
              }
            });
    Geodetic told = new Geodetic(variables.startX(), variables.startY(), start.altitudeM());
    double apartM = told.distanceM(start);
    if (variables.startSigma() > 0.0 && apartM > SAME_START_M + GATE * variables.startSigma()) {
      all.add(
          String.format(
              Locale.ROOT,
              "%s: START X, START Y are %s, but the vehicle starts %.2f km away at %s",
              origin,
              place(told),
              apartM / 1_000.0,
              place(start)));
    }
    return all;
  }

  private static double apartM(double[] one, double[] other) {
    return Math.hypot(Math.hypot(one[0] - other[0], one[1] - other[1]), one[2] - other[2]);
  }

  private static String words(double[] arm) {
    return String.join(
        " ",
        Arrays.stream(arm)
            .mapToObj(metres -> String.format(Locale.ROOT, "%.2f", metres + 0.0))
            .collect(Collectors.toList()));
  }

  private static String place(Geodetic at) {
    return String.format(Locale.ROOT, "%.6f, %.6f deg", at.longitudeDeg(), at.latitudeDeg());
  }
}
