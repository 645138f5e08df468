package org.u2sa.android.vehicle

import java.io.File
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.CopyOnWriteArrayList
import org.assertj.core.api.Assertions.assertThat
import org.awaitility.Awaitility.await
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.u2sa.android.vehicle.VehicleHost.Phase
import org.u2sa.interfaces.time.SystemClock
import org.u2sa.recorder.mcap.McapReader

/** With the real services and the real time of a vehicle. */
@Timeout(120)
class VehicleHostTest {
    @TempDir
    lateinit var folder: Path
    private val phases = CopyOnWriteArrayList<Phase>()
    private val hosts = mutableListOf<VehicleHost>()
    private var ended = 0

    private val stateFile get() = folder.resolve("run-state").toFile()

    @AfterEach
    fun close() {
        hosts.forEach {
            it.close()
            assertThat(it.awaitEnd(60)).isTrue()
        }
    }

    private fun host() = VehicleHost(RunStateFile(stateFile), SystemClock()) { phases += it.phase }.also { hosts += it }

    private fun order(services: String): VehicleHost.Order {
        val system = folder.resolve("system.xml").toFile()
        system.writeText("<system id=\"test\">$services</system>")
        return VehicleHost.Order(
            systemFile = system,
            logDirectory = File(folder.toFile(), "logs"),
            configure = { it.override("CommunicationManager", "BROKER", "none") },
            cockpit = {
                Cockpit(it, { PhoneCondition.Reading(50.0, false, null) }, { null }, PhoneFailsafe(15.0))
            },
            ended = { ended++ },
        )
    }

    private fun awaitPhase(host: VehicleHost, phase: Phase) =
        await().atMost(Duration.ofSeconds(60)).until { host.state.phase == phase }

    private val quiet = "<service class=\"org.u2sa.estimation.PassThroughStateEstimator\"/>" +
        "<service class=\"org.u2sa.core.safety.SafetyManager\"/>"

    @Test
    fun start_thenStop_runsAndLeavesNothing() {
        val host = host()
        assertThat(host.state.phase).isEqualTo(Phase.STOPPED)

        host.start(order(quiet))
        awaitPhase(host, Phase.RUNNING)
        assertThat(stateFile.readText()).isEqualTo("RUNNING")
        await().atMost(Duration.ofSeconds(60)).until {
            host.cockpit!!.snapshot.services.map { it.name }.containsAll(listOf("StateEstimator", "SafetyManager"))
        }
        assertThat(host.cockpit!!.snapshot.armed).isFalse()

        host.stop()
        awaitPhase(host, Phase.STOPPED)
        assertThat(stateFile.readText()).isEqualTo("STOPPED")
        assertThat(host.cockpit).isNull()
        assertThat(phases).containsExactly(Phase.STARTING, Phase.RUNNING, Phase.STOPPING, Phase.STOPPED)
        assertThat(ended).isEqualTo(1)
        assertThat(folder.resolve("logs/Phone.log")).exists()
    }

    @Test
    fun start_withRecorder_leavesAWholeRecordingBesideTheLogs() {
        val host = host()
        host.start(order(quiet + "<service class=\"org.u2sa.recorder.Recorder\"/>"))
        awaitPhase(host, Phase.RUNNING)
        await().atMost(Duration.ofSeconds(60)).until {
            host.cockpit!!.snapshot.services.any { it.name == "Recorder" }
        }
        host.stop()
        awaitPhase(host, Phase.STOPPED)

        McapReader.open(folder.resolve("logs/recording.mcap")).use { recording ->
            assertThat(recording.statistics().messages()).isPositive()
            assertThat(recording.channels().values.map { it.topic() }).anyMatch { it.startsWith("u2sa/test/health/") }
            assertThat(recording.attachmentNames()).anyMatch { it.endsWith("/system.xml") }.contains("logs/Phone.log")
        }
    }

    @Test
    fun start_wrongFile_saysWhatIsWrongAndRunsNothing() {
        val host = host()
        host.start(order("<service class=\"org.u2sa.NoSuch\"/>"))
        awaitPhase(host, Phase.FAILED)

        assertThat(host.state.words).contains("org.u2sa.NoSuch").contains("system.xml")
        assertThat(stateFile.readText()).isEqualTo("STOPPED")
        assertThat(ended).isEqualTo(1)
    }

    @Test
    fun start_whileOneRuns_changesNothing() {
        val host = host()
        host.start(order(quiet))
        host.start(order(quiet))
        awaitPhase(host, Phase.RUNNING)
        host.stop()
        awaitPhase(host, Phase.STOPPED)

        assertThat(phases.count { it == Phase.STARTING }).isEqualTo(1)
        assertThat(ended).isEqualTo(2)
    }

    @Test
    fun newHost_afterTheProcessDiedWhileItRan_isCrashedUntilSomebodyStopsIt() {
        stateFile.writeText("RUNNING")
        host().close() // a process that only looks does not forget it
        val host = host()
        assertThat(host.state.phase).isEqualTo(Phase.CRASHED)
        assertThat(host.state.isActive).isFalse()
        assertThat(host.cockpit).isNull()

        host.stop()
        awaitPhase(host, Phase.STOPPED)
        assertThat(host().state.phase).isEqualTo(Phase.STOPPED)
    }

    @Test
    fun close_whileItRuns_endsItInOrder() {
        val host = host()
        host.start(order(quiet))
        awaitPhase(host, Phase.RUNNING)

        host.close()
        assertThat(host.awaitEnd(60)).isTrue()
        assertThat(host.state.phase).isEqualTo(Phase.STOPPED)
        host.start(order(quiet))
        assertThat(host.state.phase).isEqualTo(Phase.FAILED)
    }
}
