package org.u2sa.mission;

import java.util.Collection;
import java.util.Optional;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

/** Constraints on a mission's waypoints and search areas beyond single fields' bounds. */
final class WaypointRules {
  private WaypointRules() {}

  static void check(Collection<GoalElement> goals) {
    GoalElement first = null;
    for (GoalElement goal : goals) {
      if (goal.message() instanceof SearchArea area) {
        area.fault()
            .ifPresent(
                fault -> {
                  throw element(goal, fault.substring(0, fault.indexOf(':'))).error(fault);
                });
      }
      if (goal.message() instanceof Waypoint waypoint) {
        checkCoordinates(goal, waypoint);
        checkThresholds(goal, waypoint);
        if (first == null) {
          first = hasPlace(waypoint) ? goal : null;
        } else if (hasPlace(waypoint)) {
          Waypoint other = (Waypoint) first.message();
          checkSameEarth(goal, waypoint, other, "waypoint in line " + first.element().line());
        }
      }
    }
  }

  /** {@link #check(Collection)} for goals that are added to a mission. */
  static void check(Collection<GoalElement> goals, GoalBook mission) {
    check(goals);
    for (GoalElement goal : goals) {
      if (goal.message() instanceof Waypoint waypoint && hasPlace(waypoint)) {
        for (GoalInformation each : mission.named(mission.names())) {
          if (each instanceof Waypoint other && hasPlace(other)) {
            checkSameEarth(goal, waypoint, other, "mission's waypoint \"" + other.uid() + "\"");
          }
        }
      }
    }
  }

  /** A station without a position is at the vehicle's position when it begins. */
  private static boolean hasPlace(Waypoint waypoint) {
    return !(waypoint instanceof Station) || waypoint.x().isPresent() || waypoint.y().isPresent();
  }

  private static void checkCoordinates(GoalElement goal, Waypoint waypoint) {
    ReferenceFrame frame = waypoint.referenceFrame();
    Home.requireFixed(frame, element(goal, "referenceFrame"));
    lack(waypoint)
        .ifPresent(
            what -> {
              throw goal.element().error(what);
            });
    if (frame.equals(ReferenceFrame.GLOBAL)) {
      goal.field("x").ifPresent(x -> XmlNumbers.checkLongitude(x, waypoint.x().orElseThrow()));
      goal.field("y").ifPresent(y -> XmlNumbers.checkLatitude(y, waypoint.y().orElseThrow()));
      goal.field("lookAt")
          .ifPresent(
              view -> {
                XmlNumbers.checkLongitude(view, waypoint.lookAt().orElseThrow().x());
                XmlNumbers.checkLatitude(view, waypoint.lookAt().orElseThrow().y());
              });
    }
  }

  /** What a goal lacks to be pursued; empty if nothing. */
  static Optional<String> lack(GoalInformation goal) {
    return goal instanceof Waypoint waypoint ? lack(waypoint) : Optional.empty();
  }

  private static Optional<String> lack(Waypoint waypoint) {
    boolean hasX = waypoint.x().isPresent();
    boolean hasY = waypoint.y().isPresent();
    boolean needsZ = waypoint instanceof TakeOff;
    boolean needsPlace = waypoint instanceof Landing || waypoint instanceof PayloadDrop;
    String what = "";
    if (waypoint.referenceFrame().isBody()) {
      what = "is in a frame that moves with the vehicle";
    } else if (!hasX && !hasY && waypoint.z().isEmpty() && hasPlace(waypoint)) {
      what = "has no coordinates; expected at least one of x, y, z";
    } else if (needsZ && waypoint.z().isEmpty()) {
      what = "lacks z; expected the altitude to which it climbs";
    } else if (needsPlace && !(hasX && hasY && waypoint.z().isPresent())) {
      what = "lacks x, y or z; expected a position on the ground";
    } else if (waypoint.referenceFrame().isUtm() && !(hasX && hasY) && !needsZ) {
      what = "lacks x or y; UTM needs both";
    }
    return Optional.of(what).filter(text -> !text.isEmpty());
  }

  private static void checkThresholds(GoalElement goal, Waypoint waypoint) {
    if (goal.field("horizontalThreshold").isPresent() && waypoint.horizontalThreshold() == 0.0) {
      throw element(goal, "horizontalThreshold")
          .error("0.0 m can never be met; expected more than 0 m");
    }
    if (waypoint.verticalThreshold().orElse(1.0) == 0.0) {
      throw element(goal, "verticalThreshold")
          .error("0.0 m can never be met; expected more than 0 m");
    }
    boolean vertical = waypoint.verticalThreshold().isPresent();
    if (vertical && waypoint.z().isEmpty()) {
      throw element(goal, "verticalThreshold")
          .error("has nothing to compare with: the goal has no <z>");
    }
    boolean onlyZ = waypoint.x().isEmpty() && waypoint.y().isEmpty();
    boolean isPlaced = waypoint instanceof TakeOff || waypoint instanceof Station;
    if (!vertical && onlyZ && waypoint.z().isPresent() && !isPlaced) {
      throw element(goal, "z")
          .error("is the only coordinate; expected a <verticalThreshold> as well");
    }
    if (waypoint.photoDistance().orElse(1.0) == 0.0) {
      throw element(goal, "photoDistance").error("0.0 m is not a distance; expected more than 0 m");
    }
    if (waypoint.speed().orElse(1.0) == 0.0) {
      throw element(goal, "speed")
          .error("0.0 m/s never reaches the waypoint; expected more than 0 m/s");
    }
  }

  private static XmlElement element(GoalElement goal, String field) {
    return goal.field(field).orElse(goal.element());
  }

  private static void checkSameEarth(
      GoalElement goal, Waypoint waypoint, Waypoint other, String otherName) {
    if (waypoint.referenceFrame().isEarth() != other.referenceFrame().isEarth()) {
      throw element(goal, "referenceFrame")
          .error(
              String.format(
                  "is in %s, but the %s is in %s; expected all on the earth or all on a local plane",
                  waypoint.referenceFrame(), otherName, other.referenceFrame()));
    }
  }
}
