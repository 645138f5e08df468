package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.messages.marine.MarineObjects;
import org.u2sa.messages.marine.Puck;
import org.u2sa.messages.shape.Box;
import org.u2sa.scenarios.roboboat.subvehicle.QuadrotorOnDeck;

/** Draws the sites of the optional tasks around the end of the channel, in random order. */
final class TaskSites {
  private static final double[] BEARINGS_DEG = {-80.0, -28.0, 28.0, 80.0};
  private static final double SPREAD_RAD = Math.toRadians(8.0);
  private static final double NEAREST_M = 18.0;
  private static final double FARTHEST_M = 24.0;
  private static final double HOOP_AHEAD_M = 4.5;
  private static final double HOOP_APART_M = 1.6;
  private static final double HOOP_RADIUS_M = 0.45;
  private static final double HOOP_TUBE_M = 0.03;
  private static final double SHORE_HEIGHT_M = 1.0; // height of hoops and targets above the water
  private static final double BUTTON_AHEAD_M = 4.0;
  private static final double BUTTON_ASIDE_M = 1.5;
  private static final double BUTTON_M = 0.4; // width, height
  private static final double BUTTON_HEIGHT_M = 0.3; // height of its centre above the water
  private static final double BUOY_BEHIND_M = 0.5; // distance of the submerged buoy from its button
  private static final double BUOY_DEPTH_M = 0.6;
  private static final double BUOY_RADIUS_M = 0.15;
  private static final double TARGET_AHEAD_M = 6.0;
  private static final double TARGET_APART_M = 2.0;
  private static final double TARGET_M = 0.6; // width, height
  private static final double HOTTER_K = 5.0;
  private static final double DOCK_WALL_M = 0.3;
  private static final double PUCK_RADIUS_M = 0.0381;
  private static final double PUCK_HEIGHT_M = 0.0254;
  private static final double THICKNESS_M = 0.1; // thickness of buttons and targets

  private final Random random;

  private TaskSites(Random random) {
    this.random = random;
  }

  /**
   * Draws the sites.
   *
   * @param end end of the channel: north, east [m]
   * @param headingRad course at its end
   */
  static List<TaskSite> around(Point end, double headingRad, Random random) {
    TaskSites draw = new TaskSites(random);
    List<Double> bearings = new ArrayList<>();
    for (double bearing : BEARINGS_DEG) {
      bearings.add(headingRad + Math.toRadians(bearing) + draw.between(-SPREAD_RAD, SPREAD_RAD));
    }
    Collections.shuffle(bearings, random);
    List<TaskSite> sites = new ArrayList<>();
    for (TaskSite.Task task : TaskSite.Task.values()) {
      double bearing = bearings.get(task.ordinal());
      double metres = draw.between(NEAREST_M, FARTHEST_M);
      sites.add(draw.site(task, TaskSite.at(end, bearing, metres, 0.0), bearing));
    }
    return List.copyOf(sites);
  }

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  private TaskSite site(TaskSite.Task task, Point station, double headingRad) {
    return switch (task) {
      case HOOP -> hoops(station, headingRad);
      case BUTTON -> buttons(station, headingRad);
      case DOCK -> dock(station, headingRad);
      case TARGET -> targets(station, headingRad);
    };
  }

  private TaskSite hoops(Point station, double headingRad) {
    List<Colour> colours = new ArrayList<>(List.of(Colour.RED, Colour.BLUE, Colour.YELLOW));
    Collections.shuffle(colours, random);
    List<ObjectDescription> hoops = new ArrayList<>();
    for (int i = 0; i < colours.size(); i++) {
      Hoop hoop = new Hoop().radius(HOOP_RADIUS_M).thickness(HOOP_TUBE_M).colour(colours.get(i));
      hoop.psi(facing(headingRad)).objectType(TaskState.name(colours.get(i), "hoop"));
      Point at = TaskSite.at(station, headingRad, HOOP_AHEAD_M, (i - 1) * HOOP_APART_M);
      hoops.add(placed(hoop, "hoop " + (i + 1), at, SHORE_HEIGHT_M));
    }
    String sought = hoops.get(random.nextInt(hoops.size())).objectType();
    return new TaskSite(TaskSite.Task.HOOP, station, headingRad, sought, hoops);
  }

  private TaskSite buttons(Point station, double headingRad) {
    boolean isRight = random.nextBoolean();
    List<ObjectDescription> objects = new ArrayList<>();
    for (double side : isRight ? new double[] {1.0, -1.0} : new double[] {-1.0, 1.0}) {
      Button button = new Button().length(THICKNESS_M).width(BUTTON_M).height(BUTTON_M);
      button.psi(facing(headingRad)).colour(Colour.RED).objectType("red button");
      Point at = TaskSite.at(station, headingRad, BUTTON_AHEAD_M, side * BUTTON_ASIDE_M);
      objects.add(
          placed(button, objects.isEmpty() ? "button" : "wrong button", at, BUTTON_HEIGHT_M));
    }
    ObjectDescription buoy = MarineObjects.named("white buoy", BUOY_RADIUS_M);
    Point at =
        TaskSite.at(
            station,
            headingRad,
            BUTTON_AHEAD_M + BUOY_BEHIND_M,
            isRight ? BUTTON_ASIDE_M : -BUTTON_ASIDE_M);
    objects.add(placed(buoy, "white buoy", at, -BUOY_DEPTH_M));
    return new TaskSite(TaskSite.Task.BUTTON, station, headingRad, "red button", objects);
  }

  private TaskSite targets(Point station, double headingRad) {
    int hot = random.nextInt(3);
    List<ObjectDescription> targets = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Box target = i == hot ? new HotTarget().excessTemperature(HOTTER_K) : new Box();
      target.length(THICKNESS_M).width(TARGET_M).height(TARGET_M).psi(facing(headingRad));
      target.objectType(i == hot ? "hot target" : "target");
      Point at = TaskSite.at(station, headingRad, TARGET_AHEAD_M, (i - 1) * TARGET_APART_M);
      targets.add(placed(target, "target " + (i + 1), at, SHORE_HEIGHT_M));
    }
    return new TaskSite(TaskSite.Task.TARGET, station, headingRad, "hot target", targets);
  }

  private TaskSite dock(Point station, double headingRad) {
    double wall = TaskSite.DOCK_WAY_M + Berth.WALL_M;
    double length = Berth.FINGERS_M + DOCK_WALL_M;
    double width = Berth.WIDTH_M + 2.0 * DOCK_WALL_M;
    Dock dock = new Dock().length(length).width(width).thickness(DOCK_WALL_M);
    dock.height(QuadrotorOnDeck.DECK_M).psi(facing(headingRad)).objectType("dock");
    Point middle = TaskSite.at(station, headingRad, wall + DOCK_WALL_M - length / 2.0, 0.0);
    Puck puck = new Puck().radius(PUCK_RADIUS_M).height(PUCK_HEIGHT_M);
    puck.objectType("puck");
    Point on = TaskSite.at(station, headingRad, wall + DOCK_WALL_M / 2.0, 0.0);
    return new TaskSite(
        TaskSite.Task.DOCK,
        station,
        headingRad,
        "puck",
        List.of(
            placed(dock, "dock", middle, QuadrotorOnDeck.DECK_M / 2.0),
            placed(puck, "puck", on, QuadrotorOnDeck.DECK_M + PUCK_HEIGHT_M / 2.0)));
  }

  /** Direction towards the station in LOCAL_ENU, anticlockwise from east [rad]. */
  private static double facing(double headingRad) {
    return Math.PI / 2.0 - headingRad - Math.PI;
  }

  private static ObjectDescription placed(
      ObjectDescription object, String uid, Point at, double upM) {
    object.uid(uid).referenceFrame(ReferenceFrame.LOCAL_ENU).x(at.y()).y(at.x()).z(upM);
    object.level(ObjectLevel.AVOID_ALWAYS).freeze();
    return object;
  }
}
