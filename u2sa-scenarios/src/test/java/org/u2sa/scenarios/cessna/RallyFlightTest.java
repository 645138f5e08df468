package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;

/** The Cessna returns to the nearer of two rally points rather than to its home. */
@Timeout(240)
class RallyFlightTest {
  private static final double LOITER_RADIUS_M = 800.0; // config/cessna/PathPlanner.xml
  private static final double ALTITUDE_M = 420.0;
  private static final Point NEAR = Point.of(7_000.0, -3_000.0, 0.0); // of home, east and north
  private static final Point FAR = Point.of(-4_000.0, 3_000.0, 0.0);

  @TempDir private Path directory;

  private static String rally(Point place) {
    Geodetic point = TroubledFlight.HOME.fromEnu(place);
    return String.format(
        Locale.ROOT,
        "<rally><x>%.7f</x><y>%.7f</y><z>%.1f</z></rally>",
        point.longitudeDeg(),
        point.latitudeDeg(),
        ALTITUDE_M);
  }

  private TroubledFlight cruise() throws IOException, InterruptedException {
    Path fence = directory.resolve("fence.xml");
    Files.writeString(fence, "<fence>" + rally(FAR) + rally(NEAR) + "</fence>");
    TroubledFlight flight =
        TroubledFlight.start(
            directory,
            11,
            "6@40",
            options ->
                Trouble.OPERATOR
                    .configure(options, FailsafeAction.RETURN)
                    .override("SafetyManager", "FENCE", fence.toString()));
    flight.flyIntoCruise();
    return flight;
  }

  private static void requireOverTheNearPoint(TroubledFlight flight) throws InterruptedException {
    flight.fly(300.0);
    double arrivedS = flight.nowS();
    flight.fly(120.0);
    for (Moment moment : flight.since(arrivedS)) {
      assertThat(Math.hypot(moment.eastM() - NEAR.x(), moment.northM() - NEAR.y()))
          .isBetween(LOITER_RADIUS_M - 50.0, LOITER_RADIUS_M + 50.0);
      assertThat(moment.altitudeM()).isBetween(ALTITUDE_M - 15.0, ALTITUDE_M + 15.0);
    }
  }

  @Test
  void failsafeReturn_rallyPointNearerThanHome_circlesOverItAtItsAltitude()
      throws IOException, InterruptedException {
    try (TroubledFlight flight = cruise()) {
      Trouble.OPERATOR.begin(flight);
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.RETURN, 30.0);
      requireOverTheNearPoint(flight);
    }
  }

  @Test
  void orderedReturn_rallyPointNearerThanHome_circlesOverItAtItsAltitude()
      throws IOException, InterruptedException {
    try (TroubledFlight flight = cruise()) {
      flight
          .witness()
          .say(
              Channels.MISSION,
              new MissionOrder().requestId("1").action(MissionAction.RETURN).operator("Ann"));
      requireOverTheNearPoint(flight);
    }
  }
}
