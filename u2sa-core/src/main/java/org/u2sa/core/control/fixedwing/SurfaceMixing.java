package org.u2sa.core.control.fixedwing;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Goes on with the surfaces that are left. A weakened aileron or rudder moves farther for the same
 * effect; what the ailerons cannot give, the rudder rolls by sideslip and dihedral, more slowly (as
 * NASA's Propulsion Controlled Aircraft and pilots' handbooks have it for lost ailerons).
 *
 * @param aileron share that is left of both ailerons, 0…1: 0.5 when one of two is lost
 * @param elevator share that is left, 0…1
 * @param rudder share that is left, 0…1
 */
record SurfaceMixing(double aileron, double elevator, double rudder) {
  /** Everything works. */
  static final SurfaceMixing SOUND = new SurfaceMixing(1.0, 1.0, 1.0);

  private static final double LEAST = 0.05; // below it a surface is as good as lost
  private static final double ROLL_BY_RUDDER = 0.5; // rudder per aileron that is missing
  private static final double FULL_PERCENT = 100.0;

  /** What to command for what the laws want. */
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

  /** What is left, for people; empty if everything is. */
  String words() {
    List<String> words = new ArrayList<>();
    tell(words, "ailerons", aileron, "rolling by the rudder, slowly");
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
