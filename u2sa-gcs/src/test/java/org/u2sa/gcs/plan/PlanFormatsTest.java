package org.u2sa.gcs.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

/** Missions in the formats of other stations and back. */
class PlanFormatsTest {
  private static final StationPlan.Place HOME =
      new StationPlan.Place(8.0, 50.0, OptionalDouble.of(120.5));

  private final List<String> lost = new ArrayList<>();

  private List<GoalInformation> thereAndBack(List<GoalInformation> goals, boolean isPlan) {
    StationPlan plan =
        new StationPlan(Optional.of(HOME), GoalItems.of(goals, lost, lost).items(), List.of());
    StationPlan read =
        isPlan
            ? QgcPlan.read("test", QgcPlan.text(plan), lost)
            : WaypointList.read("test", WaypointList.text(plan));
    assertThat(read.home()).contains(HOME);
    assertThat(lost).isEmpty();
    List<GoalInformation> back = ItemGoals.of(read, lost, lost).goals();
    assertThat(lost).isEmpty();
    return back;
  }

  private static Waypoint waypoint(int number) {
    return new Waypoint()
        .uid(Integer.toString(number))
        .x(8.0 + number / 1024.0)
        .y(50.0)
        .z(100.0 + number)
        .horizontalThreshold(2.5);
  }

  private static <T extends Waypoint> T place(Random random, T goal) {
    goal.x(8.0 + random.nextDouble()).y(-50.0 - random.nextDouble());
    if (random.nextBoolean() || goal instanceof Landing) {
      goal.z(random.nextDouble() * 1000.0);
    }
    return goal;
  }

  private static Waypoint waypoint(Random random, Waypoint goal) {
    place(random, goal).horizontalThreshold(1 + random.nextInt(100));
    return random.nextInt(3) == 0 ? goal.psi(Math.toRadians(random.nextInt(360))) : goal;
  }

  /** A hold, a landing, a delay or a circle: without end, for a time or turns, to an altitude. */
  private static Waypoint other(Random random) {
    Station station = random.nextInt(4) == 0 ? new Station() : place(random, new Station());
    boolean hasRadius = random.nextBoolean();
    if (hasRadius) {
      station.radius((1 + random.nextInt(300)) * (random.nextBoolean() ? 1 : -1));
    }
    boolean isToNext = random.nextBoolean();
    switch (random.nextInt(8)) {
      case 7:
        return new TakeOff().z(random.nextDouble() * 1000.0);
      case 0:
        return waypoint(random, new Station().duration(1 + random.nextInt(60)));
      case 1:
        return place(random, new Landing()).psi(Math.toRadians(random.nextInt(360)));
      case 2:
        return new Station().duration(1 + random.nextInt(60)); // a delay
      case 3:
        return station; // without end
      case 4:
        station.turns(0.5 + random.nextInt(9));
        break;
      case 5:
        station.duration(0.0); // to the altitude
        break;
      default:
        station.duration(1 + random.nextInt(60));
        isToNext |= !hasRadius;
    }
    return isToNext ? station.towardsNext(true) : station;
  }

  private static void camera(Random random, Waypoint goal) {
    if (random.nextInt(4) == 0) {
      goal.photoDistance(1 + random.nextInt(80));
    }
    if (random.nextInt(4) == 0) {
      goal.lookAt(Point.of(8.0 + random.nextDouble(), -50.5, random.nextDouble() * 100.0));
    }
    if (random.nextInt(8) == 0) {
      goal.landingStart(true);
    }
  }

  /** All that both formats can say, at random. */
  private static List<GoalInformation> mission(Random random) {
    List<GoalInformation> goals = new ArrayList<>();
    int count = 1 + random.nextInt(12);
    boolean isLinked = random.nextBoolean();
    for (int i = 1; i <= count; i++) {
      Waypoint goal = random.nextBoolean() ? other(random) : waypoint(random, new Waypoint());
      goal.uid(Integer.toString(i));
      camera(random, goal);
      if (random.nextInt(3) == 0) {
        goal.speed(1 + random.nextInt(40));
      }
      if (random.nextInt(5) == 0) {
        goal.repeatFrom(Integer.toString(1 + random.nextInt(i))).repeatTimes(1 + random.nextInt(5));
      }
      if (isLinked && i < count) {
        goal.next(List.of(Integer.toString(i + 1)));
      } else if (isLinked) {
        int to = random.nextInt(count + 1);
        goal.next(List.of(to == 0 ? "home" : Integer.toString(to)));
      }
      goals.add(goal);
    }
    return goals;
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void thereAndBack_whatTheFormatsCanSay_isEqual(boolean isPlan) {
    for (int seed = 0; seed < 500; seed++) {
      List<GoalInformation> goals = mission(new Random(seed));
      assertThat(PlanXml.mission(Optional.empty(), thereAndBack(goals, isPlan)))
          .as("seed %s", seed)
          .isEqualTo(PlanXml.mission(Optional.empty(), goals));
    }
  }

  @Test
  void export_speedOfSomeGoals_isSetBeforeThemAndGivenBackAfterwards() {
    List<PlanItem> items =
        GoalItems.of(List.of(waypoint(1), waypoint(2).speed(7.0), waypoint(3)), lost, lost).items();

    assertThat(items).extracting(PlanItem::command).containsExactly(16, 178, 16, 178, 16);
    assertThat(items.get(1).parameter(2)).isEqualTo(7.0);
    assertThat(items.get(3).parameter(2)).isEqualTo(-2.0);
  }

  @Test
  void export_camera_isOrderedWhereItChanges() {
    Point tower = Point.of(8.5, 50.5, 30.0);
    List<GoalInformation> goals =
        List.of(
            waypoint(1).photoDistance(25.0).lookAt(tower),
            waypoint(2).photoDistance(25.0).lookAt(tower),
            waypoint(3).landingStart(true));

    List<PlanItem> items = GoalItems.of(goals, lost, lost).items();

    assertThat(items)
        .extracting(PlanItem::command)
        .containsExactly(206, 195, 16, 16, 206, 197, 189, 16);
    assertThat(items.get(0).parameter(1)).isEqualTo(25.0);
    assertThat(items.get(1).parameters().subList(4, 7)).containsExactly(50.5, 8.5, 30.0);
  }

  @Test
  void export_stationThatNoItemSays_isNamed() {
    Station both = new Station().turns(2.0).duration(5.0).radius(50.0).uid("1");
    GoalItems.of(List.of(both.x(8.0).y(50.0).psi(0.5).horizontalThreshold(3.0)), lost, lost);

    assertThat(lost)
        .containsExactly(
            "goal \"1\": stays within horizontalThreshold 3.0 m",
            "goal \"1\": has turns and duration 5.0",
            "goal \"1\": has psi of 28.64788975654116 deg in addition");
  }

  @Test
  void export_whatItemsCannotSay_isNamed() {
    Waypoint local = new Waypoint().uid("1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(1).y(2);
    Waypoint named = waypoint(2).verticalThreshold(3.0);
    named.uid("gate").next(List.of("1", "2"));
    named.nextIf(GoalResult.FAILED, List.of("1")).timeLimit(60.0);

    GoalItems.of(List.of(local.next(List.of("gate")), named), lost, lost);

    assertThat(lost)
        .containsExactlyInAnyOrder(
            "goal \"gate\": its name",
            "goal \"gate\": has several next goals",
            "goal \"1\": has no longitude and latitude in the frame Global",
            "goal \"gate\": has verticalThreshold 3.0",
            "goal \"gate\": has timeLimit 60.0",
            "goal \"gate\": has nextIfFailed [1]");
  }

  @Test
  void export_goalsAtZeroDegrees_areNamedAsItemsThereMeanThePresentPosition() {
    Waypoint there = waypoint(1).x(0.0).y(-0.0);
    Station station = new Station().duration(5.0).uid("2");
    GoalItems made = GoalItems.of(List.of(there, station.x(0.0).y(0.0).z(30.0)), lost, lost);

    assertThat(made.items()).isEmpty();
    assertThat(lost)
        .containsExactly(
            "goal \"1\": is at 0, 0, which in items means the present position",
            "goal \"2\": is at 0, 0, which in items means the present position");
  }

  @Test
  void import_altitudesRelativeToHome_addItsAltitude() {
    String list =
        "QGC WPL 110\n"
            + "0\t1\t0\t16\t0\t0\t0\t0\t50\t8\t120\t1\n"
            + "1\t0\t3\t16\t0\t5\t0\t0\t50.1\t8.1\t30\t1\n";

    Waypoint goal =
        (Waypoint) ItemGoals.of(WaypointList.read("a", list), lost, lost).goals().get(0);

    assertThat(goal.z()).hasValue(150.0);
    assertThat(goal.horizontalThreshold()).isEqualTo(5.0);
    assertThat(goal.psi()).isEmpty(); // 0 of writers that know no empty heading
    assertThat(lost).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "'205,2,0,0,0,0,0,0,0,1', 'item 1 (MAV_CMD_DO_MOUNT_CONTROL): no goal can express that'",
    "'21,0,10,0,0,0,50,8,30,1', 'item 1 (MAV_CMD_NAV_LAND): an abort altitude'",
    "'21,0,0,0,0,0,50,8,nan,1', 'item 1 (MAV_CMD_NAV_LAND): no altitude of the ground'",
    "'18,0,0,0,0,0,50,8,30,1', 'item 1 (MAV_CMD_NAV_LOITER_TURNS): 0.0 turns'",
    "'93,2,-1,12,0,0,0,0,0,1', 'item 1 (MAV_CMD_NAV_DELAY): until a time of day'",
    "'189,2,0,0,0,0,0,0,0,1', 'the landing starts after the last goal'",
    "'195,0,0,0,0,0,50,8,nan,1', 'item 1 (MAV_CMD_DO_SET_ROI_LOCATION): expected latitude'",
    "'201,0,2,0,0,0,50,8,30,1', 'item 1 (MAV_CMD_DO_SET_ROI): a view of mode 2.0'",
    "'22,0,15,0,0,0,50,8,30,1', 'item 1 (MAV_CMD_NAV_TAKEOFF): a pitch of 15.0 deg'",
    "'206,2,25,9,0,0,0,0,0,1', 'item 1 (MAV_CMD_DO_SET_CAM_TRIGG_DIST): a shutter time of 9.0'",
    "'16,10,0,0,0,0,50,8,30,1', 'an altitude in frame 10'",
    "'16,3,0,0,0,0,0,0,30,1', 'latitude 0.0, longitude 0.0 is not a position'",
    "'16,3,0,0,50,0,50,8,30,1', 'a pass-by radius of 50.0 m'",
    "'16,3,0,0,0,0,50,8,30,0', 'waits for an operator'",
    "'177,2,5,1,0,0,0,0,0,1', 'jumps to item 5.0, which is not an earlier goal'",
    "'178,2,2,5,-1,0,0,0,0,1', 'a speed of type 2.0; expected 0 or 1'",
    "'178,2,0,0,-1,0,0,0,0,1', 'a speed of 0.0 m/s; expected more than 0'",
    "'16,1,0,0,0,0,50,8,30,1', 'frame 1'",
    "'20,2,0,0,0,0,0,0,0,1', 'nothing comes before it'",
    "'178,2,0,5,50,0,0,0,0,1', 'a throttle of 50.0 %'",
  })
  void import_whatGoalsCannotSay_isNamed(String item, String what) {
    String list =
        "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t50\t8\t120\t1\n1\t0\t"
            + item.replaceFirst("(\\d+),(\\d+)", "$2,$1").replace(',', '\t');

    ItemGoals.of(WaypointList.read("a", list), lost, lost);

    assertThat(lost).anyMatch(each -> each.contains(what));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "QGC WPL 120 | a, line 1: \"QGC WPL 120\": expected QGC WPL 110",
        "QGC WPL 110 | a, line 1: no items; expected the home as item 0",
        "QGC WPL 110;1 0 0 16 0 0 0 0 0 0 0 1 | a, line 2: index: expected 0",
        "QGC WPL 110;0 0 0 16 0 0 0 0 0 0 | a, line 2: 10 columns; expected 12",
        "QGC WPL 110;0 0 0 16 0 x 0 0 0 0 0 1 | a, line 2: column 6 \"x\": expected a number",
        "QGC WPL 110;0 0 0 -1 0 0 0 0 0 0 0 1 | a, line 2: column 4 \"-1\": expected a whole number",
      })
  void read_brokenList_isRefusedWithLineAndColumn(String text, String message) {
    assertThatThrownBy(() -> WaypointList.read("a", text.replace(';', '\n')))
        .isInstanceOf(BadInputException.class)
        .hasMessage(message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{} | a: fileType: expected \"Plan\"",
        "{'fileType':'Plan'} | a: mission: expected an object",
        "{'fileType':'Plan','mission':{'items':[{'type':'SimpleItem','params':[1]}]}} | a: mission.items[0].params: 1 numbers; expected 7",
        "{'fileType':'Plan','mission':{'items':[]},'geoFence':{'circles':[{'circle':{'center':[50,8],'radius':-5}}]}} | a: geoFence.circles.circle.radius: -5.0; expected more than 0 m",
        "{'fileType':'Plan','mission':{'items':[],'plannedHomePosition':[95,8,0]}} | a: plannedHomePosition: 95.0, 8.0 is not on the earth",
      })
  void read_brokenPlan_isRefusedWithTheField(String text, String message) {
    assertThatThrownBy(() -> QgcPlan.read("a", text.replace('\'', '"'), lost))
        .isInstanceOf(BadInputException.class)
        .hasMessage(message);
  }

  @Test
  void fence_ofAPlan_isAFileAndWhatThatCannotSayIsNamed() {
    List<StationPlan.Place> corners =
        List.of(
            HOME,
            new StationPlan.Place(8.1, 50.0, OptionalDouble.empty()),
            new StationPlan.Place(8.0, 50.1, OptionalDouble.empty()));
    List<StationPlan.Area> areas =
        List.of(
            new StationPlan.Area(true, corners, OptionalDouble.empty()),
            new StationPlan.Area(false, List.of(HOME), OptionalDouble.of(30.0)));
    StationPlan plan = new StationPlan(Optional.of(HOME), List.of(), areas);

    StationPlan read = QgcPlan.read("a", QgcPlan.text(plan), lost);
    String file = PlanXml.fence("", read.areas(), read.rally(), lost);

    assertThat(lost).isEmpty();
    assertThat(file)
        .contains("<keepIn>\n    <corner><x>8.0</x><y>50.0</y></corner>")
        .contains(
            "<keepOut>\n    <centre><x>8.0</x><y>50.0</y></centre>\n    <radius>30.0</radius>");
    StationPlan.Area circle = new StationPlan.Area(true, List.of(HOME), OptionalDouble.of(9.0));
    assertThat(PlanXml.fence("", List.of(circle, circle), List.of(), lost))
        .containsOnlyOnce("<keepIn>");
    assertThat(lost).containsExactly("fence: a second circle to stay within");
  }

  @Test
  void rallyPoints_thereAndBack_areEqualAndAboveHomeInPlans() {
    StationPlan.Place home = new StationPlan.Place(8.0, 50.0, OptionalDouble.of(100.0));
    StationPlan.Place point = new StationPlan.Place(8.1, 50.1, OptionalDouble.of(160.5));
    StationPlan plan = new StationPlan(Optional.of(home), List.of(), List.of(), List.of(point));

    String text = QgcPlan.text(plan);

    assertThat(text).contains("\"points\" : [ [ 50.1, 8.1, 60.5 ] ]");
    assertThat(QgcPlan.read("a", text, lost)).isEqualTo(plan);
    assertThat(PlanXml.fence("", List.of(), plan.rally(), lost)).contains("<z>160.5</z>");
    assertThat(lost).isEmpty();
  }

  @Test
  void list_homeThatIsNoPlaceOrHasNoAltitude_isRefusedOrWithout() {
    String item = "\n1\t0\t0\t16\t0\t0\t0\tNaN\t45\t10\t5\t1\n";
    for (String place : List.of("95\t10", "45\t-180.5", "NaN\t10")) {
      String text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t" + place + "\t3\t1" + item;
      assertThatThrownBy(() -> WaypointList.read("a.waypoints", text))
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("a.waypoints: item 0: ");
    }
    String flat = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t45\t10\tNaN\t1" + item;
    StationPlan plan = WaypointList.read("a.waypoints", flat);
    assertThat(plan.home().orElseThrow().altitudeM()).isEmpty();
  }
}
