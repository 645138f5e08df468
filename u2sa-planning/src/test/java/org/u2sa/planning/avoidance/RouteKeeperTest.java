package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.planning.route.Route;

/** When routes are planned. The vehicle stands at the origin, its goal 8 m to the north. */
class RouteKeeperTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final RouteKeeper routes = bench.routes;

  @BeforeEach
  void planFirst() {
    routes.begin();
    routes.update(bench.at(0.0));
  }

  @Test
  void update_routeIsFree_isKeptHoweverLong() {
    routes.update(bench.at(60.0));

    assertThat(bench.requests).hasSize(1);
    assertThat(routes.track()).isPresent();
  }

  @Test
  void update_obstacleOnTheRoute_plansAtOnce() {
    bench.see(AvoidanceBench.post(4.0, 0.0));
    routes.update(bench.at(0.1));

    assertThat(bench.requests).hasSize(2);
  }

  /** From the edge of what has just stopped, a straight route would lead through its middle. */
  @Test
  void update_obstacleFromTheVehicleOnward_plansAtOnce() {
    bench.see(AvoidanceBench.ball(3.4, 3.0));
    routes.update(bench.at(0.1));

    assertThat(bench.requests).hasSize(2);
  }

  @Test
  void update_obstacleThatTheRouteLeaves_routeIsKept() {
    bench.see(AvoidanceBench.ball(-3.4, 3.0));
    routes.update(bench.at(0.1));

    assertThat(bench.requests).hasSize(1);
  }

  /** A wall that the vehicle did not see when it planned, nearer than the end of closed cells. */
  @Test
  void update_wallBetweenTheVehicleAndFreeCells_plansAtOnce() {
    bench.see(
        AvoidanceBench.post(0.45, -0.2),
        AvoidanceBench.post(0.45, 0.0),
        AvoidanceBench.post(0.45, 0.2));
    routes.update(bench.at(0.1));

    assertThat(bench.requests).hasSize(2);
  }

  @Test
  void update_obstacleBesideTheRoute_plansWhenDueAndKeepsTheRouteUnlessClearlyWorse() {
    var before = routes.track();
    bench.see(AvoidanceBench.post(4.0, 3.0));
    routes.update(bench.at(0.1));
    assertThat(bench.requests).hasSize(1);

    bench.see(AvoidanceBench.post(4.0, -3.0));
    routes.update(bench.at(5.0));
    assertThat(bench.requests).hasSize(2);
    assertThat(routes.track()).isEqualTo(before);
  }

  @Test
  void update_betterRouteAfterAChange_isTaken() {
    var before = routes.track();
    bench.answer = AvoidanceBench.northward(8.0, 5.0);
    bench.see(AvoidanceBench.post(4.0, 3.0));
    routes.update(bench.at(5.0));

    assertThat(routes.track()).isPresent().isNotEqualTo(before);
    assertThat(routes.track().get().cost()).isEqualTo(5.0);
  }

  @ParameterizedTest
  @CsvSource({"7.9, 0.2, 2", "7.9, -0.2, 2", "7.9, 0.05, 1", "5.0, 0.2, 1"})
  void update_steeredVehicleAtTheEndOfTheRoute_isPlannedAgainUnlessAligned(
      double northM, double headingRad, int plans) {
    AvoidanceBench truck = new AvoidanceBench();
    truck.routes.update(truck.steered(0.0, 0.0, 0.0));
    var before = truck.routes.track();
    for (double north = 1.0; north < northM; north++) {
      truck.routes.update(truck.steered(0.1 * north, north, 0.0));
    }
    truck.routes.update(truck.steered(5.0, northM, headingRad));

    assertThat(truck.requests).hasSize(plans);
    assertThat(truck.routes.track().equals(before)).isEqualTo(plans == 1);
    truck.answer = Route.none("a wall");
    truck.routes.update(truck.steered(10.0, northM, headingRad));
    assertThat(truck.routes.track()).isPresent();
  }

  /** A control that stops a little short of the route's end would not reach the goal. */
  @Test
  void update_routeEndsAtTheEdgeOfTheThreshold_isPlannedAgainThroughNarrowerPassages() {
    AvoidanceBench turning = new AvoidanceBench();
    turning.turnsOnTheSpot = true;
    turning.answer = AvoidanceBench.northward(7.55, 7.55);
    turning.routes.update(turning.at(0.0));
    assertThat(turning.routes.track()).isPresent();
    assertThat(turning.said).anyMatch(line -> line.contains("obstacles at the goal"));

    turning.answer = AvoidanceBench.northward(7.9, 9.0);
    turning.routes.update(turning.at(5.0));
    assertThat(turning.routes.track().orElseThrow().cost()).isEqualTo(9.0);
    turning.routes.update(turning.at(10.0));
    assertThat(turning.requests).hasSize(2);
  }

  @Test
  void update_vehicleOffTheRoute_plansWhenDue() {
    routes.update(bench.at(0.1, 0.0, 3.0));
    assertThat(bench.requests).hasSize(1);

    routes.update(bench.at(5.0, 0.0, 3.0));
    assertThat(bench.requests).hasSize(2);
  }

  @Test
  void update_noRoute_isTriedAgainOnlyInAnotherWorld() {
    bench.answer = Route.none("a wall");
    bench.see(AvoidanceBench.post(4.0, 0.0));
    routes.update(bench.at(5.0));
    assertThat(routes.track()).isEmpty();
    assertThat(routes.obstacle()).isEqualTo("a wall");
    int tried = bench.requests.size();

    routes.update(bench.at(10.0));
    assertThat(bench.requests).hasSize(tried);

    bench.see();
    routes.update(bench.at(15.0));
    assertThat(bench.requests).hasSize(tried + 1);
  }

  /** Where it is by then it may have room to turn, though the world is the same. */
  @Test
  void update_noRouteOfAVehicleThatCannotStop_isTriedAgainAsItFliesOn() {
    AvoidanceBench flying = new AvoidanceBench(Map.of("MIN SPEED", 1.0));
    flying.answer = Route.none("a pillar ahead");
    flying.routes.update(flying.at(0.0));
    flying.routes.update(flying.at(0.1));
    assertThat(flying.requests).hasSize(1);

    flying.answer = AvoidanceBench.northward(8.0, 8.0);
    flying.routes.update(flying.at(5.0, 5.0, 0.0));

    assertThat(flying.routes.track()).isPresent();
  }

  /** A failed search takes long. */
  @Test
  void update_noRouteForLong_isTriedLessAndLessOften() {
    AvoidanceBench flying = new AvoidanceBench(Map.of("MIN SPEED", 1.0));
    flying.answer = Route.none("a pillar ahead");

    for (double s = 0.0; s < 120.0; s += 0.1) {
      flying.routes.update(flying.at(s));
    }

    assertThat(flying.requests).hasSizeBetween(10, 25);
  }

  @Test
  void update_noRouteWithRoomToTurn_triesNarrowerPassagesOnce() {
    bench.turnsOnTheSpot = true;
    bench.answer = Route.none("a wall");
    bench.see(AvoidanceBench.post(4.0, 0.0));
    routes.update(bench.at(5.0));
    routes.update(bench.at(10.0));
    routes.update(bench.at(12.0));

    assertThat(bench.requests).hasSize(3);
    assertThat(bench.said).containsExactly("no route with room to turn: trying narrower passages");
  }

  private void findNoRoute() {
    bench.answer = Route.none("the goal is occupied");
    bench.see(AvoidanceBench.post(8.0, 0.0));
    routes.update(bench.at(5.0));
    routes.update(bench.at(6.0));
  }

  /** What stood there when it was last seen may have left. */
  @Test
  void update_noRouteForAWhile_leadsNearTheGoalToLookWhetherThatIsSo() {
    findNoRoute();
    assertThat(routes.track()).isEmpty();

    bench.answer = AvoidanceBench.northward(5.0, 5.0);
    routes.update(bench.at(10.0));
    assertThat(bench.requests.get(bench.requests.size() - 1).toleranceM()).isGreaterThan(3.0);
    assertThat(bench.said).anyMatch(line -> line.contains("going nearer"));
    routes.update(bench.at(12.0, 2.0, 0.0));
    assertThat(routes.track()).isPresent();

    bench.answer = Route.none("the goal is occupied");
    routes.update(bench.at(15.0, 4.9, 0.0));
    routes.update(bench.at(30.0, 4.9, 0.0));
    assertThat(routes.track()).as("it is there").isEmpty();
    assertThat(bench.requests.get(bench.requests.size() - 1).toleranceM()).isEqualTo(0.5);
  }

  @Test
  void update_onItsWayToLookAndTheGoalIsFree_leadsToTheGoal() {
    findNoRoute();
    bench.answer = AvoidanceBench.northward(5.0, 5.0);
    routes.update(bench.at(10.0));

    bench.answer = AvoidanceBench.northward(8.0, 8.0);
    bench.see();
    routes.update(bench.at(15.0, 2.0, 0.0));
    assertThat(bench.requests.get(bench.requests.size() - 1).toleranceM()).isEqualTo(0.5);
    assertThat(routes.track().orElseThrow().cost()).isEqualTo(8.0);
  }

  @Test
  void update_unfinishedSearch_goesOnAtEachStep() {
    routes.dropUntil(0);
    bench.answer = Route.sought();
    routes.update(bench.at(5.0));
    routes.update(bench.at(5.1));

    assertThat(bench.requests).hasSize(3);
    assertThat(routes.isSearching()).isTrue();
  }

  @Test
  void dropUntil_time_plansFromThen() {
    routes.dropUntil(AvoidanceBench.micros(10.0) - bench.settings.replanMicros());
    routes.update(bench.at(9.9));
    assertThat(routes.track()).isEmpty();

    routes.update(bench.at(10.0));
    assertThat(routes.track()).isPresent();
  }

  @Test
  void begin_anotherGoal_forgetsRouteAndObstacle() {
    bench.answer = Route.none("a wall");
    bench.see(AvoidanceBench.post(4.0, 0.0));
    routes.update(bench.at(5.0));

    routes.begin();

    assertThat(routes.obstacle()).isEmpty();
    assertThat(routes.track()).isEmpty();
  }
}
