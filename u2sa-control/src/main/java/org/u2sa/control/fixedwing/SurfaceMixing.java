package org.u2sa.control.fixedwing;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Reconfigures the commands for the remaining surfaces. A weakened aileron or rudder deflects
 * farther for the same effect; the rudder replaces missing aileron authority through sideslip and
 * dihedral, more slowly (as NASA's Propulsion Controlled Aircraft programme and pilots' handbooks
 * recommend for lost ailerons).
 *
 * @param aileron remaining effectiveness of both ailerons, 0…1: 0.5 when one of two is lost
 * @param elevator remaining share, 0…1
 * @param rudder remaining share, 0…1
 */
record SurfaceMixing(double aileron, double elevator, double rudder) {
  /** All surfaces healthy. */
  static final SurfaceMixing SOUND = new SurfaceMixing(1.0, 1.0, 1.0);

  private static final double LEAST = 0.05; // below it a surface is practically lost
  private static final double ROLL_BY_RUDDER = 0.5; // rudder per missing aileron
  private static final double FULL_PERCENT = 100.0;

  /** Commands for the surfaces wanted by the laws. */
  Surfaces of(Surfaces wanted) {
    if (equals(SOUND)) {
      return wanted;
    }
    double turned = farther(wanted.aileron(), aileron);
    double missing = wanted.aileron() - aileron * turned;
    double lostShare = aileron < LEAST ? 1.0 : Math.min(1.0, Math.abs(missing));
    double yawed = (1.0 - lostShare) * wanted.rudder() + ROLL_BY_RUDDER * missing;
    return new Surfaces(
        turned,
        farther(wanted.elevator(), elevator),
        farther(yawed, rudder),
        wanted.throttle(),
        wanted.mixture(),
        wanted.flaps(),
        wanted.brakes());
  }

  private static double farther(double wanted, double left) {
    return left < LEAST ? 0.0 : Limit.symmetric(wanted / left, 1.0);
  }

  /** Human-readable remaining authority; empty if all is healthy. */
  String words() {
    List<String> words = new ArrayList<>();
    tell(words, "ailerons", aileron, "rolling slowly, by rudder");
    tell(words, "elevator", elevator, "cannot control pitch");
    tell(words, "rudder", rudder, "sideslip is not controlled");
    return String.join("; ", words);
  }

  private static void tell(List<String> words, String surface, double left, String without) {
    if (left < LEAST) {
      words.add(surface + " lost: " + without);
    } else if (left < 1.0) {
      words.add(String.format(Locale.ROOT, "%s %.0f %% left", surface, FULL_PERCENT * left));
    }
  }
}
