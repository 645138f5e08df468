package org.u2sa.planning.rightofway;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoublePredicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * Decides by the rules of right of way which course and speed to keep among other vessels. Not
 * thread-safe.
 *
 * <p>An encounter begins with a risk of collision on the vehicle's intended or present course. If
 * the vehicle gives way, it alters its course once, early and clearly, and keeps the new course
 * until its intended course is free. If it stands on, it holds its course until the other vessel
 * should have acted but has not.
 */
public final class RightOfWay {
  private static final double LOST_S = 20.0; // age of a track at which its encounter ends
  private static final double SURE_S = 2.0;

  /** Ranges at which slowly approaching vessels are kept clear of [required distances]. */
  private static final double GIVE_WAY_RANGES = 3.0;

  private static final double STAND_ON_RANGES = 1.5;
  private static final double OTHER_LEG_RAD = Math.toRadians(10.0);

  private final Supplier<RightOfWayVariables> variables;
  private final Consumer<String> say;
  private final Map<String, Encounter> encounters = new LinkedHashMap<>();
  private Optional<CourseOrder> manoeuvre = Optional.empty();
  private final Lasting due = new Lasting(SURE_S);
  private final Lasting free = new Lasting(SURE_S);
  private final Lasting unsafe = new Lasting(SURE_S);
  private double lastS = Double.NaN;
  private RightOfWayVariables settings; // settings of the current decision

  /**
   * @param say reports the beginning of an encounter and each decision
   */
  public RightOfWay(Supplier<RightOfWayVariables> variables, Consumer<String> say) {
    this.variables = variables;
    this.say = say;
  }

  /**
   * Decides.
   *
   * @param targets other vessels under way now
   * @param isOpen whether static obstacles leave a course [rad, clockwise from north] free
   * @param nowS current time [s]
   * @return course and speed to keep; empty if the vehicle may go to its goal
   */
  public Optional<CourseOrder> decide(
      OwnShip own, List<Target> targets, DoublePredicate isOpen, double nowS) {
    settings = variables.get();
    List<Target> all = follow(targets, nowS);
    CourseChoice choice = new CourseChoice(own, encounters.values(), all, settings, isOpen);
    all.forEach(target -> beginIfAtRisk(target, own, choice, nowS));
    boolean acts = false;
    for (Encounter each : encounters.values()) {
      acts |= isDue(each, own, choice);
    }
    Optional<CourseOrder> before = manoeuvre;
    boolean isFree = free.lasts(before.isPresent() && choice.isFree(own.courseRad()), nowS);
    boolean isUnsafe = unsafe.lasts(before.filter(now -> !choice.isKept(now)).isPresent(), nowS);
    boolean isDue = due.lasts(before.isEmpty() && acts, nowS);
    if (isFree) {
      manoeuvre = Optional.empty();
      encounters.values().forEach(each -> each.hold(own.courseRad()));
      say.accept("right of way: resumes its course");
    } else if (isUnsafe || isDue) {
      manoeuvre = Optional.of(choice.choose(before, reason(own, choice)));
    }
    manoeuvre.filter(now -> isOther(now, before)).ifPresent(now -> say.accept(now.toString()));
    endWhatIsClear(own, choice, nowS);
    return manoeuvre.or(() -> held(own, choice));
  }

  /** Encounters with their rules, in the order in which they began; empty if there are none. */
  public String remark() {
    return encounters.values().stream().map(Encounter::toString).collect(Collectors.joining("; "));
  }

  private static boolean isOther(CourseOrder now, Optional<CourseOrder> before) {
    return before.isEmpty()
        || now.courseRad() != before.get().courseRad()
        || now.speedShare() != before.get().speedShare();
  }

  /** Updates the encounters; returns the targets with those whose tracks were lost just now. */
  private List<Target> follow(List<Target> targets, double nowS) {
    double since = Double.isNaN(lastS) ? 0.0 : nowS - lastS;
    lastS = nowS;
    List<Target> all = new ArrayList<>(targets);
    Map<String, Target> seen =
        targets.stream().collect(Collectors.toMap(Target::name, each -> each, (one, two) -> one));
    for (Iterator<Encounter> each = encounters.values().iterator(); each.hasNext(); ) {
      Encounter encounter = each.next();
      Target newest = seen.get(encounter.target().name());
      if (newest != null) {
        encounter.see(newest, nowS);
      } else if (encounter.unseen(since, nowS) > LOST_S) {
        each.remove();
      } else {
        all.add(encounter.target());
      }
    }
    return all;
  }

  private void beginIfAtRisk(Target target, OwnShip own, CourseChoice choice, double nowS) {
    if (encounters.containsKey(target.name())) {
      return;
    }
    Approach intended = own.approach(target, own.courseRad(), own.speedMps());
    Approach present = own.presentApproach(target);
    boolean onPresent = manoeuvre.isPresent() && isRisk(target, present, choice);
    if (onPresent || isRisk(target, intended, choice)) {
      double course = onPresent ? own.presentCourseRad() : own.courseRad();
      Encounter begun = Encounter.begin(target, present, course, nowS);
      encounters.put(target.name(), begun);
      say.accept("right of way: encounter with " + begun);
    }
  }

  private boolean isRisk(Target target, Approach approach, CourseChoice choice) {
    double time = approach.closestS();
    return time > 0.0
        && time <= settings.riskHorizon()
        && choice.share(target, approach, settings.riskHorizon()) < 1.0;
  }

  /** Whether it is time to act for an encounter, on the intended course. */
  private boolean isDue(Encounter encounter, OwnShip own, CourseChoice choice) {
    Target target = encounter.target();
    double speed = own.speedMps();
    Approach approach = own.approach(target, own.courseRad(), speed);
    boolean byRule =
        encounter.rule() != Rule.HEAD_ON || !approach.passesToStarboard(own.courseRad());
    double required = byRule ? 1.0 : 1.1;
    double time = approach.closestS();
    double requiredM = choice.requiredM(target, 0.0);
    if (time <= 0.0 || choice.share(target, approach, settings.riskHorizon()) >= required) {
      return false;
    }
    if (encounter.rule().givesWay()) {
      return time <= settings.giveWayTime() || approach.rangeM() <= GIVE_WAY_RANGES * requiredM;
    }
    boolean late =
        time <= settings.standOnTime() || approach.rangeM() <= STAND_ON_RANGES * requiredM;
    if (late && !encounter.actsItself()) {
      encounter.actItself();
      say.accept("right of way: \"" + target.name() + "\" does not give way");
    }
    return encounter.actsItself();
  }

  private String reason(OwnShip own, CourseChoice choice) {
    String names =
        encounters.values().stream()
            .filter(Encounter::mustAct)
            .filter(each -> isDue(each, own, choice))
            .map(each -> "\"" + each.target().name() + "\" (rule " + rule(each) + ")")
            .collect(Collectors.joining(", "));
    return "right of way: keeps clear of " + (names.isEmpty() ? "other vessels" : names);
  }

  private static String rule(Encounter each) {
    return each.actsItself() ? "17(a)(ii)" : each.rule().numbers();
  }

  private void endWhatIsClear(OwnShip own, CourseChoice choice, double nowS) {
    if (manoeuvre.isPresent()) {
      return;
    }
    Collection<Encounter> all = encounters.values();
    all.removeIf(
        each -> {
          Approach present = own.presentApproach(each.target());
          boolean isClear =
              present.closestS() <= 0.0 && present.rangeM() >= choice.requiredM(each.target(), 0.0);
          return each.isOver(isClear, nowS);
        });
  }

  /** A vessel that stands on does not turn onto another leg before the other vessel is clear. */
  private Optional<CourseOrder> held(OwnShip own, CourseChoice choice) {
    for (Encounter each : encounters.values()) {
      double course = each.courseRad();
      boolean turns = Math.abs(Angles.wrapped(own.courseRad() - course)) > OTHER_LEG_RAD;
      Approach ahead = own.approach(each.target(), course, own.speedMps());
      if (!each.mustAct() && turns && isRisk(each.target(), ahead, choice)) {
        return Optional.of(
            new CourseOrder(
                course,
                1.0,
                own.courseRad(),
                "right of way: stands on for \"" + each.target().name() + "\""));
      }
    }
    return Optional.empty();
  }
}
