package org.u2sa.planning.rightofway;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.planning.PathPlanner;

/** Right-of-way variables of a {@link PathPlanner}. */
public record RightOfWayVariables(
    @Variable(ifAbsentText = "NONE")
        @Description(
            "COLREGS gives way or stands on by rules 8 and 13 to 17; NONE ignores right of way.")
        Rules rightOfWay,
    @Variable(unit = "m", min = 0, minExcluded = true, max = 100_000, ifAbsent = 20)
        @Description(
            "With RIGHT OF WAY: distance at which other vessels are passed, beyond both radii and the uncertainty of their tracks.")
        double passingDistance,
    @Variable(unit = "s", min = 0, minExcluded = true, max = 36_000, ifAbsent = 240)
        @Description(
            "With RIGHT OF WAY: time to the closest point of approach at which the rule of an encounter is decided.")
        double riskHorizon,
    @Variable(unit = "s", min = 0, minExcluded = true, max = 36_000, ifAbsent = 120)
        @Description(
            "With RIGHT OF WAY: time to the closest point of approach by which the vehicle must have given way.")
        double giveWayTime,
    @Variable(unit = "s", min = 0, minExcluded = true, max = 36_000, ifAbsent = 60)
        @Description(
            "With RIGHT OF WAY: time to the closest point of approach at which a vehicle that stands on takes action itself (rule 17).")
        double standOnTime,
    @Variable(unit = "deg", min = 5, max = 90, ifAbsent = 35)
        @Description(
            "With RIGHT OF WAY: minimum alteration of course, large enough to be seen (rule 8).")
        double minAlteration) {
  /** Rules of right of way. */
  public enum Rules {
    /** No right of way. */
    NONE,
    /** Convention on the International Regulations for Preventing Collisions at Sea, 1972. */
    COLREGS
  }

  public boolean isOn() {
    return rightOfWay == Rules.COLREGS;
  }
}
