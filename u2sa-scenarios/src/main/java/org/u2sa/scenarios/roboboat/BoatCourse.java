package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.scenarios.roboboat.gate.Gate;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.CurrentField;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.Waves;
import org.u2sa.sim.world.World;

/**
 * A course: two speed gates ahead of the start, a channel of gates that ends at a blue buoy, and
 * the weather. Positions are north and east of the start, which faces north [m].
 *
 * @param start initial position of the boat
 * @param headingRad initial heading
 * @param speedGates speed gates, passed first
 * @param channel gates of the channel, in order
 * @param end the blue buoy behind the channel
 * @param sites sites of the optional tasks
 */
record BoatCourse(
    Point start,
    double headingRad,
    List<Gate> speedGates,
    List<Gate> channel,
    Point end,
    List<TaskSite> sites,
    Weather weather) {
  /** Site of the competition: Nathan Benderson Park, Florida. */
  static final Geodetic ORIGIN = new Geodetic(-82.4507, 27.3767, 0.0);

  private static final double HOME_BEHIND_M = 2.0; // the start

  /** Colour of the buoys to the left on the way out. */
  static final Colour LEFT = Colour.ORANGE;

  /** Colour of the buoys to the right on the way out. */
  static final Colour RIGHT = Colour.GREEN;

  /** Colour of the buoy at the end of the channel. */
  static final Colour END = Colour.BLUE;

  private static final double RADIUS_M = 0.25;
  private static final double END_RADIUS_M = 0.4;
  private static final double FLOATS_M = 0.1; // centre above the water
  private static final double SPREAD_RAD = 0.3;
  private static final double TASKS_FROM_M = 5.0; // start of a tasks-only run, before the gate

  /**
   * Weather of a run.
   *
   * @param windMps steady wind
   * @param windFromRad direction it blows from
   * @param currentEastMps eastward current
   * @param currentNorthMps northward current
   * @param waveM significant height of the waves; 0: none
   * @param wavePeriodS their peak period
   * @param seed seed of gusts and waves
   */
  record Weather(
      double windMps,
      double windFromRad,
      double currentEastMps,
      double currentNorthMps,
      double waveM,
      double wavePeriodS,
      long seed) {}

  /** The same course with only the last gate and the boat in front of it. */
  BoatCourse tasksOnly() {
    Gate last = channel.get(channel.size() - 1);
    double heading = Math.atan2(last.way().y(), last.way().x());
    return new BoatCourse(
        last.beyond(-TASKS_FROM_M), heading, List.of(), List.of(last), end, sites, weather);
  }

  TaskSite site(TaskSite.Task task) {
    return sites.stream().filter(each -> each.task() == task).findFirst().orElseThrow();
  }

  /** All buoys, and the objects of the tasks. */
  List<ObjectDescription> objects() {
    List<ObjectDescription> objects = new ArrayList<>();
    List<Gate> all = new ArrayList<>(speedGates);
    all.addAll(channel);
    for (int i = 0; i < all.size(); i++) {
      objects.add(buoy("left " + (i + 1), LEFT, all.get(i).left(), RADIUS_M));
      objects.add(buoy("right " + (i + 1), RIGHT, all.get(i).right(), RADIUS_M));
    }
    objects.add(buoy("end", END, end, END_RADIUS_M));
    sites.forEach(site -> objects.addAll(site.objects()));
    return objects;
  }

  private static ObjectDescription buoy(String uid, Colour colour, Point at, double radiusM) {
    ObjectDescription buoy =
        new Buoy()
            .colour(colour)
            .radius(radiusM)
            .uid(uid)
            .objectType(TaskState.name(colour, "buoy"))
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(at.y())
            .y(at.x())
            .z(FLOATS_M)
            .level(ObjectLevel.AVOID_ALWAYS);
    buoy.freeze();
    return buoy;
  }

  /** The world of the run. */
  World world() {
    Optional<Waves> waves =
        weather.waveM() == 0.0
            ? Optional.empty()
            : Optional.of(
                Waves.of(
                    Waves.Spectrum.JONSWAP,
                    weather.waveM(),
                    weather.wavePeriodS(),
                    weather.windFromRad() + Math.PI,
                    SPREAD_RAD,
                    weather.seed()));
    CurrentField current =
        CurrentField.uniform(weather.currentEastMps(), weather.currentNorthMps());
    return World.at(ORIGIN)
        .with(objects())
        .with(new Water(0.0, current, waves))
        .with(Wind.gusty(weather.windFromRad(), weather.windMps(), weather.seed()));
  }

  /** Position at which a run ends: north, east [m]. */
  Point home() {
    return TaskSite.at(start(), headingRad(), -HOME_BEHIND_M, 0.0);
  }
}
