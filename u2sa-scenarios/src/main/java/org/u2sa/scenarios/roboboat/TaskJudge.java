package org.u2sa.scenarios.roboboat;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.scenarios.roboboat.subvehicle.FetchJudge;
import org.u2sa.scenarios.roboboat.subvehicle.PuckGripper;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Scores the optional tasks by ground truth: darts through the right hoop, the right button
 * pressed, the reported position of the hot target, and the puck fetched from the dock. Confined to
 * the judge's thread.
 */
final class TaskJudge {
  /** Largest error of a reported target that counts [m]. */
  static final double TARGET_M = 2.0;

  private final Map<TaskSite.Task, TaskSite> sites;
  private final BiConsumer<Double, String> log; // with the time [s]
  private final LocalPlane plane = new LocalPlane(BoatCourse.ORIGIN);
  private final Random random;
  private boolean wasPulled;
  private int fired;
  private int hits;
  private OptionalDouble targetErrorM = OptionalDouble.empty();
  private final Berth berth;
  private final NavigableMap<Double, Boolean> inBay = new TreeMap<>(); // by start time [s]
  private boolean isEntered;
  private boolean isDocked;
  private final FetchJudge fetch;

  TaskJudge(List<TaskSite> sites, PuckGripper gripper, long seed, BiConsumer<Double, String> log) {
    this.sites = sites.stream().collect(Collectors.toMap(TaskSite::task, site -> site));
    random = new Random(seed);
    fetch = new FetchJudge(gripper);
    berth = new Berth(this.sites.get(TaskSite.Task.DOCK));
    this.log = log;
  }

  /** Judges a shot when the dart gun's trigger is pulled. */
  void trigger(boolean isPulled, VehicleTruth boat) {
    if (isPulled && !wasPulled) {
      fired++;
      Dart dart = Dart.shot(boat, random);
      boolean isHit = dart.passes((Hoop) sites.get(TaskSite.Task.HOOP).object());
      hits += isHit ? 1 : 0;
      log.accept(boat.timeS(), "dart " + fired + (isHit ? " through the hoop" : " misses"));
    }
    wasPulled = isPulled;
  }

  /**
   * Judges the boat in the dock, and its sub-vehicle.
   *
   * @param quadrotor empty before it is switched on
   */
  void dock(VehicleTruth boat, Optional<VehicleTruth> quadrotor) {
    boolean isHere = berth.isDocked(boat);
    if (isHere && !isDocked) {
      log.accept(boat.timeS(), "docked");
    }
    isDocked |= isHere;
    if (berth.isEntered(boat) != isEntered) {
      isEntered = !isEntered;
      inBay.put(boat.timeS(), isEntered);
    }
    boolean wasGripped = fetch.isGripped();
    boolean wasBack = fetch.isBack();
    quadrotor.ifPresent(truth -> fetch.see(truth, boat, isHere));
    if (fetch.isGripped() && !wasGripped) {
      log.accept(boat.timeS(), "the quadrotor has the puck");
    }
    if (fetch.isBack() && !wasBack) {
      log.accept(boat.timeS(), "the quadrotor is back with the puck");
    }
  }

  /** Judges a report of a target; the first one counts. */
  void reported(TargetReport report, double timeS) {
    TaskSite site = sites.get(TaskSite.Task.TARGET);
    Point at = plane.point(new Geodetic(report.x(), report.y(), 0.0));
    Point truth = site.object().center();
    double error = Math.hypot(at.x() - truth.x(), at.y() - truth.y());
    log.accept(
        timeS, String.format(Locale.ROOT, "%s reported, %.2f m off", report.target(), error));
    if (targetErrorM.isEmpty() && report.target().equals(site.sought())) {
      targetErrorM = OptionalDouble.of(error);
    }
  }

  /** Whether a contact is the press of the right button. */
  private boolean isPress(ContactWatch.Contact contact) {
    return contact.object().equals(sites.get(TaskSite.Task.BUTTON).object());
  }

  /** Whether a contact is allowed: with the right button, or the dock while in its bay. */
  boolean isWanted(ContactWatch.Contact contact) {
    return isPress(contact) || isInBay(contact);
  }

  private boolean isInBay(ContactWatch.Contact contact) {
    Map.Entry<Double, Boolean> newest = inBay.floorEntry(contact.timeS());
    return contact.object() instanceof Dock && newest != null && newest.getValue();
  }

  /** Name of a contact in the judge's log. */
  String words(ContactWatch.Contact contact) {
    return isInBay(contact) ? "against a wall of the bay" : "touches " + contact.object().uid();
  }

  /** Adds the tasks to the score sheet. */
  void outcome(
      RunningVehicle run,
      List<String> violations,
      Map<String, Integer> counts,
      Map<String, Double> figures) {
    Optional<ContactWatch.Contact> first =
        run.contacts().stream().filter(each -> each.object() instanceof Button).findFirst();
    boolean isRight = first.filter(this::isPress).isPresent();
    if (first.isPresent() && !isRight) {
      violations.add("pressed the wrong button");
    }
    if (fetch.isLeftBehind()) {
      violations.add("left the dock without the quadrotor");
    }
    boolean isLocated = targetErrorM.isPresent() && targetErrorM.getAsDouble() <= TARGET_M;
    counts.put("dartsFired", fired);
    counts.put("dartsThroughHoop", hits);
    counts.put("buttonPressed", isRight ? 1 : 0);
    counts.put("hotTargetReported", isLocated ? 1 : 0);
    counts.put("docked", isDocked ? 1 : 0);
    counts.put("puckFetched", fetch.isBack() ? 1 : 0);
    List<Boolean> done = List.of(hits > 0, isRight, isLocated, fetch.isBack());
    counts.put("tasksDone", Collections.frequency(done, true));
    targetErrorM.ifPresent(error -> figures.put("hotTargetErrorM", error));
  }
}
