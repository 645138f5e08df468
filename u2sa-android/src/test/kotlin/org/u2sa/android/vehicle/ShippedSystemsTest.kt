package org.u2sa.android.vehicle

import java.io.File
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.time.Duration
import org.assertj.core.api.Assertions.assertThat
import org.awaitility.Awaitility.await
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.u2sa.android.sensor.PhoneSensors
import org.u2sa.android.sensor.PhoneStateSensor
import org.u2sa.android.vehicle.VehicleHost.Phase
import org.u2sa.interfaces.time.SystemClock

/** What is in the APK, copied as there, runs: all services, with a board that is not there. */
@Timeout(180)
class ShippedSystemsTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var host: VehicleHost

    @BeforeEach
    fun make() {
        File("../config/ugv").copyRecursively(File(folder.toFile(), "config/ugv"))
        File("../missions/ugv").copyRecursively(File(folder.toFile(), "missions/ugv"))
        File("src/main/assets").copyRecursively(folder.toFile())
        host = VehicleHost(RunStateFile(File(folder.toFile(), "run-state")), SystemClock()) {}
    }

    @AfterEach
    fun close() {
        host.close()
        assertThat(host.awaitEnd(60)).isTrue()
    }

    /** A port where nobody listens. */
    private fun deadPort() = ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { it.localPort }

    @ParameterizedTest
    @ValueSource(strings = ["system.xml", "system-board.xml", "system-pass-through.xml", "system-phone.xml", "system-ackermann.xml", "system-proportional.xml"])
    fun start_eachSystem_runsAllServicesAndCannotBeArmedWithoutABoard(name: String) {
        val board = "tcp:127.0.0.1:${deadPort()}"
        host.start(
            VehicleHost.Order(
                systemFile = folder.resolve("config/ugv/$name").toFile(),
                logDirectory = folder.resolve("logs").toFile(),
                configure = {
                    it.override("CommunicationManager", "BROKER", "none").override("IoioService", "CONNECTION", board)
                    it.making(PhoneStateSensor::class.java) { context -> PhoneStateSensor(context, NoSensors) }
                },
                cockpit = { Cockpit(it, { PhoneCondition.Reading(50.0, false, null) }, { false }, PhoneFailsafe(15.0)) },
            ),
        )
        await().atMost(Duration.ofSeconds(90)).until { host.state.phase != Phase.STOPPED && host.state.phase != Phase.STARTING }
        assertThat(host.state.phase).describedAs(host.state.words).isEqualTo(Phase.RUNNING)

        val cockpit = requireNotNull(host.cockpit)
        await().atMost(Duration.ofSeconds(90)).until {
            val seen = cockpit.snapshot
            seen.services.map { it.name }.containsAll(listOf("IoioService", "PathPlanner", "SafetyManager", "HealthMonitor")) &&
                seen.goals.isNotEmpty() && seen.armingReasons.isNotEmpty() && PhoneFailsafe.Hazard.BOARD_LOST in seen.hazards
        }
        assertThat(cockpit.arm(true)).isFalse()
    }

    private object NoSensors : PhoneSensors {
        override fun read() = PhoneSensors.Reading(trouble = "there are none")

        override fun close() = Unit
    }
}
