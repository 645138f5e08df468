package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/**
 * Shipped system files with the vehicles beside them, without a demo. Left out are those that need
 * a demo's painted images: igvc and the competition of suas.
 */
class ShippedVehiclesTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({
    "cessna/system.xml, cessna/vehicle.xml",
    "cessna/system-world.xml, cessna/vehicle.xml",
    "roboboat/system.xml, roboboat/vehicle.xml",
    "roboboat/system-camera.xml, roboboat/vehicle.xml",
    "roboboat/system-holonomic.xml, roboboat/vehicle-holonomic.xml",
    "roboboat/quadrotor/system.xml, roboboat/quadrotor/vehicle.xml",
    "robosub/system.xml, robosub/vehicle.xml",
    "robosub/system-without-estimator.xml, robosub/vehicle.xml",
    "suas/hexacopter/system.xml, suas/hexacopter/vehicle.xml",
    "suas/hexacopter/system-world.xml, suas/hexacopter/vehicle.xml",
    "suas/plane/system.xml, suas/plane/vehicle.xml",
    "suas/quadcopter/system.xml, suas/quadcopter/vehicle.xml",
    "ugv/system.xml, ugv/vehicle.xml",
    "ugv/system-world.xml, ugv/vehicle.xml",
    "vrx/system.xml, vrx/vehicle.xml"
  })
  void simulate_asShipped_everyServiceFindsItsDevices(String system, String vehicle) {
    Path config = Repository.root().resolve("config");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            config.resolve(system).toString(),
            "--vehicle",
            config.resolve(vehicle).toString(),
            "--limit",
            "2",
            "--port",
            "0",
            "--summary-only",
            "--out",
            folder.resolve("out").toString());
    assertThat(run.err()).isEmpty();
    assertThat(run.out())
        .contains("simulated 0:02")
        .doesNotContain("LEVER ARMS") // the estimator knows the places of the sensors
        .doesNotContain("START X");
  }
}
