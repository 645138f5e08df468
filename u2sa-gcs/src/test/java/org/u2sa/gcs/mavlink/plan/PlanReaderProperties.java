package org.u2sa.gcs.mavlink.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.plan.PlanXml;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/** Missions that go to a station and come back, and items that no honest station sends. */
class PlanReaderProperties {
  private static final Optional<Geodetic> HOME = Optional.of(new Geodetic(10.0, 54.0, 30.0));

  private static GoalInformation goal(Random random, int number, int count, boolean isLinked) {
    boolean stays = random.nextInt(4) == 0;
    Waypoint goal = stays ? new Station().duration(1 + random.nextInt(60)) : new Waypoint();
    goal.uid(Integer.toString(number)).horizontalThreshold(1 + random.nextInt(9));
    goal.x((random.nextInt(3_600_000) - 1_800_000) / 1e4).y(random.nextInt(900_000) / 1e4);
    goal.z(random.nextInt(1000) / 4.0);
    if (random.nextInt(4) == 0) {
      goal.photoDistance(1 + random.nextInt(50));
    }
    if (random.nextInt(4) == 0) {
      goal.lookAt(Point.of((100_000 + random.nextInt(1000)) / 1e4, 54.0, random.nextInt(100)));
    }
    if (random.nextInt(8) == 0) {
      goal.landingStart(true);
    }
    if (random.nextInt(3) == 0) {
      goal.speed(1 + random.nextInt(40) / 10.0);
    }
    if (random.nextInt(5) == 0) {
      goal.repeatFrom(Integer.toString(1 + random.nextInt(number))).repeatTimes(2);
    }
    if (isLinked) {
      int back = 1 + random.nextInt(count);
      String last = random.nextBoolean() ? "home" : Integer.toString(back);
      goal.next(List.of(number < count ? Integer.toString(number + 1) : last));
    }
    return goal;
  }

  @Property(tries = 300)
  void readWhatWasWritten_missions_areEqual(@ForAll long seed, @ForAll boolean startsWithHome) {
    Random random = new Random(seed);
    int count = 1 + random.nextInt(9);
    boolean isLinked = random.nextBoolean();
    List<GoalInformation> goals = new ArrayList<>();
    for (int i = 1; i <= count; i++) {
      goals.add(goal(random, i, count, isLinked));
    }
    int first = startsWithHome ? 1 : 0;
    MissionReport report = new MissionReport().mission("m").goals(goals).sequence(List.of());

    MissionPlan plan = PlanWriter.plan(report, VehicleKind.COPTER, first);
    PlanReader back = new PlanReader(VehicleKind.COPTER, HOME, plan.items(), first);

    assertThat(back.names()).isEqualTo(plan.goals());
    String written = PlanXml.mission(Optional.empty(), goals).replaceAll(">\\s+<", "><");
    assertThat(back.xml().replaceFirst("<home>.*</home>", "")).isEqualTo(written);
  }

  @Property(tries = 300)
  void read_anyItems_isAMissionOrARefusal(@ForAll long seed) {
    Random random = new Random(seed);
    int[] commands = {
      16, 17, 18, 19, 20, 21, 22, 31, 93, 177, 178, 189, 195, 197, 201, 206, random.nextInt(65_536)
    };
    List<MissionItem> items = new ArrayList<>();
    for (int i = random.nextInt(6); i >= 0; i--) {
      float[] p = new float[5];
      for (int k = 0; k < p.length; k++) {
        p[k] = random.nextBoolean() ? random.nextInt(4) : Float.intBitsToFloat(random.nextInt());
      }
      int x = random.nextBoolean() ? 540_000_000 : random.nextInt();
      int command = commands[random.nextInt(commands.length)];
      items.add(
          new MissionItem(
              random.nextInt(8), command, 1, p[0], p[1], p[2], p[3], x, random.nextInt(), p[4]));
    }
    VehicleKind kind = VehicleKind.values()[random.nextInt(VehicleKind.values().length)];
    try {
      assertThat(new PlanReader(kind, HOME, items, 0).xml()).doesNotContain("NaN", "Infinity");
    } catch (PlanRefusal e) {
      assertThat(e.getMessage()).contains("mission");
    }
  }
}
