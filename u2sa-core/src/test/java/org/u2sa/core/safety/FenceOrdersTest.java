package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;

/** Fences that operators order while a vehicle stands at the origin of its local frame. */
class FenceOrdersTest extends WatchedVehicle {
  @TempDir private Path folder;
  private int orders;

  /** A square around the origin, or beside it. */
  private static String square(double fromX, double toX) {
    return String.format(
        """
        <fence><reference>Local ENU</reference><keepIn>
        <corner><x>%1$s</x><y>-50</y></corner><corner><x>%2$s</x><y>-50</y></corner>
        <corner><x>%2$s</x><y>50</y></corner><corner><x>%1$s</x><y>50</y></corner>
        </keepIn></fence>""",
        fromX, toX);
  }

  private FenceOrderResult order(FenceOrder order) {
    return repeated(order.requestId("o" + ++orders).operator("Ann"));
  }

  private FenceOrderResult repeated(FenceOrder order) {
    kit.publish(Channels.FENCE_ORDERS, order);
    live(0.2);
    return kit.published(Channels.FENCE_ORDERS).stream()
        .filter(FenceOrderResult.class::isInstance)
        .map(FenceOrderResult.class::cast)
        .filter(result -> result.requestId().equals(order.requestId()))
        .reduce((first, second) -> second)
        .orElseThrow();
  }

  private FenceOrderResult replace(String xml) {
    return order(new FenceOrder().action(FenceAction.REPLACE).fence(xml).file("new.xml"));
  }

  private FenceState fence() {
    return kit.latest(Channels.FENCE).orElseThrow();
  }

  private void configure(String xml) throws IOException {
    Path file = Files.writeString(folder.resolve("configured.xml"), xml);
    kit.with("FENCE", file.toString());
  }

  @Test
  void start_withAFenceOfAFile_publishesItsTextFileAndMargin() throws IOException {
    configure("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + square(-50, 50));
    kit.with("FENCE MARGIN", 2.0);
    start();
    live(0.2);

    assertThat(fence().fence()).contains("\n" + square(-50, 50));
    assertThat(fence().file()).contains("configured.xml");
    assertThat(fence().margin()).isEqualTo(2.0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"1e-300", "1e-9", "0.05", "3"})
  void replace_circlesOfAnySize_areAnsweredAndPublished(String radius) {
    start();
    live(0.2);
    FenceOrderResult result =
        replace(
            "<fence><reference>Local ENU</reference><keepOut><centre><x>40</x><y>0</y></centre><radius>"
                + radius
                + "</radius></keepOut></fence>");

    assertThat(result.accepted()).as(result.outcome()).isTrue();
    assertThat(fence().keepOut())
        .allSatisfy(area -> assertThat(area.points()).hasSizeGreaterThan(2));
    assertThat(fence().keepOut()).hasSize(radius.equals("1e-300") ? 0 : 1);
  }

  @Test
  void replace_thinKeepInAreaWithAMargin_isAnsweredAndPublished() {
    kit.with("FENCE MARGIN", 2.0);
    start();
    live(0.2);
    FenceOrderResult result =
        replace(
            "<fence><reference>Local ENU</reference><keepIn><corner><x>0</x><y>0</y></corner>"
                + "<corner><x>200</x><y>0</y></corner><corner><x>200</x><y>4.06</y></corner>"
                + "<corner><x>0</x><y>4.06</y></corner></keepIn></fence>");

    assertThat(result.accepted()).as(result.outcome()).isTrue();
    assertThat(fence().keepIn()).hasSize(1);
  }

  /** Ways home depend on the published areas: without them they are straight. */
  @Test
  void replace_hundredsOfAreas_arePublishedCoarselyAndCoverThoseOfTheFile() {
    kit.with("FENCE MARGIN", 2.0);
    start();
    live(0.2);
    StringBuilder fence = new StringBuilder("<fence><reference>Local ENU</reference>");
    for (int i = 1; i <= 300; i++) {
      int x = 40 * i;
      fence.append("<keepOut>");
      for (String corner : List.of("0 0", "10 0", "10 10", "0 10")) {
        String[] at = corner.split(" ");
        fence.append(
            String.format(
                "<corner><x>%d</x><y>%s</y></corner>", x + Integer.parseInt(at[0]), at[1]));
      }
      fence.append("</keepOut>");
    }
    assertThat(replace(fence.append("</fence>").toString()).accepted()).isTrue();

    List<Polygon> published = fence().keepOut();
    assertThat(published).hasSize(300);
    assertThat(published.stream().mapToInt(area -> area.points().size()).sum()).isLessThan(2_001);
    for (int i = 1; i <= 300; i++) {
      Polygon area = published.get(i - 1);
      for (Point corner :
          List.of(Point.of(0.1, 0.1, 0.0), Point.of(9.9, 0.1, 0.0), Point.of(9.9, 9.9, 0.0))) {
        assertThat(area.distanceTo(Point.of(40 * i + corner.x(), corner.y(), 0.0))).isZero();
      }
    }
  }

  @Test
  void replace_moreCornersThanCanBePublished_saysThatReturnsAreStraight() {
    start();
    live(0.2);
    StringBuilder fence = new StringBuilder("<fence><reference>Local ENU</reference>");
    for (int i = 1; i <= 90; i++) {
      String circle = "<keepOut><centre><x>%d</x><y>0</y></centre><radius>1500</radius></keepOut>";
      fence.append(String.format(circle, 3_100 * i));
    }

    FenceOrderResult result = replace(fence.append("</fence>").toString());
    assertThat(result.accepted()).isTrue();
    assertThat(result.outcome())
        .contains("; too many corners to lead around: returns are straight");
    assertThat(fence().keepOut()).isEmpty();
    assertThat(replace(square(-50, 50)).outcome()).doesNotContain("straight");
  }

  @Test
  void start_withoutAFence_publishesThatThereIsNone() {
    start();
    live(0.2);

    assertThat(fence().fence()).isEmpty();
    assertThat(fence().file()).isEmpty();
  }

  @Test
  void replace_aroundAnArmedVehicle_isInForceAtOnceAndPublished() {
    startArmed();

    FenceOrderResult result = replace(square(-50, 50));

    assertThat(result.accepted()).as(result.outcome()).isTrue();
    assertThat(fence().fence()).contains(square(-50, 50));
    assertThat(fence().file()).contains("new.xml");
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void replace_besideAnArmedVehicle_isRefusedAndTheOldFenceStays() throws IOException {
    configure(square(-50, 50));
    startArmed();

    FenceOrderResult result = replace(square(10, 50));

    assertThat(result.accepted()).isFalse();
    assertThat(result.outcome())
        .isEqualTo("new.xml: the vehicle is armed and violates it: outside");
    assertThat(fence().fence()).contains(square(-50, 50));
    live(1.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void replace_besideADisarmedVehicle_isInForceAndAReasonNotToArm() {
    start();
    live(0.3);

    FenceOrderResult result = replace(square(10, 50));

    assertThat(result.accepted()).isTrue();
    assertThat(result.outcome()).contains("arming is not possible: outside the keep-in area");
    assertThat(arm(true).reasons())
        .contains("geofence: outside the keep-in area, or inside a keep-out one");
  }

  @Test
  void replace_armedWithoutAPosition_isRefused() {
    startArmed();
    kit.advance(5.0);
    kit.publish(
        Channels.FENCE_ORDERS,
        new FenceOrder().requestId("o9").action(FenceAction.REPLACE).fence(square(-50, 50)));
    kit.advance(0.2);

    assertThat(kit.latest(Channels.FENCE_ORDERS).orElseThrow())
        .isInstanceOfSatisfying(
            FenceOrderResult.class,
            result -> assertThat(result.outcome()).contains("without a position to compare"));
  }

  @ParameterizedTest
  @CsvSource({
    "<fence/>, lacks <keepIn>",
    "<mission/>, expected the root element <fence>",
    "<fence><keepIn><corner><x>0</x><y>0</y></corner></keepIn></fence>, has 1 <corner>",
    "<fence><keepIn><corner><x>NaN</x><y>0</y></corner></keepIn></fence>, NaN",
    "no fence, new.xml"
  })
  void replace_byWhatIsNoFence_isRefusedNamingFileAndFault(String xml, String fault) {
    start();

    FenceOrderResult result = replace(xml);

    assertThat(result.accepted()).isFalse();
    assertThat(result.outcome()).startsWith("new.xml").contains(fault);
    assertThat(fence().file()).isEmpty();
  }

  @Test
  void replace_thatCrossesItself_isRefused() {
    start();
    String bow = square(-50, 50).replaceFirst("<x>50.0</x><y>50", "<x>50.0</x><y>-80");

    assertThat(replace(bow).outcome()).contains("encloses no area in one piece");
  }

  @Test
  void remove_thenReload_leavesNoFenceAndThenThatOfTheFile() throws IOException {
    configure(square(-50, 50));
    startArmed();

    assertThat(order(new FenceOrder().action(FenceAction.REMOVE)).accepted()).isTrue();
    assertThat(fence().file()).isEmpty();

    assertThat(order(new FenceOrder().action(FenceAction.RELOAD)).accepted()).isTrue();
    assertThat(fence().fence()).contains(square(-50, 50));
  }

  @Test
  void order_repeated_isAnsweredButNotExecutedAgain() {
    start();
    FenceOrder first = new FenceOrder().action(FenceAction.REPLACE).fence(square(-50, 50));
    assertThat(order(first).accepted()).isTrue();
    order(new FenceOrder().action(FenceAction.REMOVE));

    assertThat(repeated((FenceOrder) first.copy()).accepted()).isTrue();

    assertThat(fence().file()).isEmpty();
  }

  @Test
  void order_arrivesAgainAtARestartedManager_isAnsweredButNotExecutedAgain() {
    SafetyManager manager = startArmedManager();
    FenceOrder first = new FenceOrder().action(FenceAction.REPLACE).fence(square(-50, 50));
    assertThat(order(first).accepted()).isTrue();
    order(new FenceOrder().action(FenceAction.REMOVE));
    kit.restart(manager, SafetyManager::new);
    kit.advance(0.6);

    assertThat(repeated((FenceOrder) first.copy()).accepted()).isTrue();

    assertThat(fence().file()).isEmpty();
  }

  @Test
  void vehicle_leavesAnOrderedFence_isAFailsafe() {
    kit.with("ON FENCE", "HOLD");
    startArmed();
    replace(square(-1000, 1000));
    kit.send(
        Channels.STATE,
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(60.0).xSigma(1.0));
    kit.advance(0.2);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes()).containsExactly("geofence: outside");
  }

  @Test
  void restart_afterAnOrder_keepsTheOrderedFence() throws IOException {
    configure(square(-50, 50));
    SafetyManager manager = startArmedManager();
    replace(square(-40, 40));
    kit.restart(manager, SafetyManager::new);
    live(1.0);

    assertThat(fence().fence()).contains(square(-40, 40));
  }

  @Test
  void restart_afterAnOrderThatIsLost_keepsTheFenceThatIsPublished() throws IOException {
    configure(square(-50, 50));
    SafetyManager manager = startArmedManager();
    replace(square(-40, 40));
    kit.loseState("SafetyManager");
    kit.restart(manager, SafetyManager::new);
    live(1.0);

    assertThat(fence().fence()).contains(square(-40, 40));
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
  }

  private static String withRally(String xml, String... points) {
    StringBuilder rally = new StringBuilder();
    for (String point : points) {
      String[] xyz = point.split(" ");
      rally.append("<rally><x>" + xyz[0] + "</x><y>" + xyz[1] + "</y>");
      rally.append(xyz.length > 2 ? "<z>" + xyz[2] + "</z></rally>" : "</rally>");
    }
    return xml.replace("</fence>", rally + "</fence>");
  }

  private List<String> rally() {
    return fence().rally().stream().map(GoalInformation::uid).collect(Collectors.toList());
  }

  @Test
  void replace_rallyPointsInside_arePublished() {
    startArmed();

    assertThat(replace(withRally(square(-50, 50), "10 20 30", "-5 0")).accepted()).isTrue();

    assertThat(rally()).containsExactly("rally 1", "rally 2");
    Waypoint first = (Waypoint) fence().rally().get(0);
    assertThat(first.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_ENU);
    assertThat(first.x()).hasValue(10.0);
    assertThat(first.z()).hasValue(30.0);
  }

  @Test
  void replace_rallyPointsOnly_isAFenceThatLimitsNothing() {
    startArmed();

    assertThat(replace(withRally("<fence><reference>Local ENU</reference></fence>", "10 20")))
        .matches(FenceOrderResult::accepted);

    live(0.5);
    assertThat(rally()).containsExactly("rally 1");
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @ParameterizedTest
  @CsvSource({
    "60 0, outside the keep-in area",
    "49 0, outside the keep-in area", // by the margin
    "0 0 130, above the ceiling of 118",
    "0 0 -5, below the floor of 12"
  })
  void replace_newRallyPointThatCannotBeUsed_isRefusedByName(String point, String why) {
    kit.with("FENCE MARGIN", 2.0);
    start();
    String limits =
        square(-50, 50).replace("<keepIn>", "<floor>10</floor><ceiling>120</ceiling><keepIn>");

    FenceOrderResult result = replace(withRally(limits, "1 1", point));

    assertThat(result.accepted()).isFalse();
    assertThat(result.outcome()).startsWith("new.xml: rally 2 at x ").contains(why);
  }

  @Test
  void replace_aroundOldRallyPointsPartly_isInForceAndDoesNotUseThoseOutside() {
    start();
    replace(withRally(square(-50, 50), "40 0", "5 0"));

    FenceOrderResult result = replace(withRally(square(-20, 20), "40 0", "5 0"));

    assertThat(result.outcome()).endsWith("in force; outside it, so unused: rally 1");
    assertThat(rally()).containsExactly("rally 2");
  }

  @Test
  void replace_moreRallyPointsThanAllowed_isRefused() {
    start();
    String[] points = new String[101];
    Arrays.fill(points, "0 0");

    assertThat(replace(withRally(square(-50, 50), points)).outcome())
        .contains("has 101 <rally>; expected at most 100");
  }

  @Test
  void order_olderThanItsExpiry_isRefused() {
    start();
    live(30.0);
    FenceOrder late = new FenceOrder().action(FenceAction.REPLACE).fence(square(-50, 50));
    late.timestamp(kit.clock().micros() - Clock.micros(20.0));

    FenceOrderResult result = order(late);

    assertThat(result.accepted()).isFalse();
    assertThat(result.outcome()).startsWith("the order arrived 20.");
  }
}
