package org.u2sa.android.vehicle

import java.io.File
import java.util.concurrent.TimeUnit
import org.assertj.core.api.Assertions.assertThat
import org.junit.After
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.u2sa.android.OnPhone
import org.u2sa.android.board.BoardChoice
import org.u2sa.android.file.VehicleFiles
import org.u2sa.android.file.vehicleFiles
import org.u2sa.testkit.Repository

private const val FAR_ENOUGH_MPS = 0.3

/** The application drives the vehicle that `./u2sa board` simulates, over the network, as docs/android.md describes it. */
@RunWith(RobolectricTestRunner::class)
class SimulatedBoardTest {
    @get:Rule val folder = TemporaryFolder()

    private val root: File = Repository.root().toFile()
    private val phone = OnPhone()
    private lateinit var said: File
    private lateinit var board: Process

    @Before
    fun serve() {
        said = folder.newFile("board.log")
        board = ProcessBuilder(
            File(root, "u2sa").path, "board", "--vehicle", File(root, "config/ugv/vehicle.xml").path,
            "--mission", File(root, "missions/ugv/loop.xml").path, "--listen", "127.0.0.1:0", "--status",
        ).redirectErrorStream(true).redirectOutput(said).start()
        phone.await("the board, which may have to be built first", 600) { address.containsMatchIn(said.readText()) }
    }

    @After
    fun close() {
        phone.close()
        board.destroy()
        check(board.waitFor(60, TimeUnit.SECONDS)) { "the board does not end" }
    }

    private val address = Regex("IOIO board at tcp:127\\.0\\.0\\.1:(\\d+)")

    /** The folder that a user copies to the phone. */
    private fun import() {
        val files = listOf("config/ugv", "missions/ugv").flatMap { File(root, it).listFiles().orEmpty().filter(File::isFile) }
        vehicleFiles(phone.application).import(
            "desk",
            files.asSequence().map { VehicleFiles.Source(it.relativeTo(root).path) { it.inputStream() } },
        )
    }

    @Test
    fun arm_simulatedBoardOnTheNetwork_drivesTheMissionUntilTheBoardIsGone() {
        import()
        PhoneSettings(phone.application).apply {
            system = "desk/config/ugv/system-board.xml"
            board = BoardChoice.Tcp("127.0.0.1", address.find(said.readText())!!.groupValues[1].toInt())
        }
        phone.allowAll()
        phone.createService()
        phone.startVehicle()
        phone.await("readiness") { phone.service.snapshot.motion != null && phone.service.snapshot.armingReasons.isEmpty() }
        assertThat(said.readText()).contains("is connected").doesNotContain("MOTOR 100 %")

        phone.service.arm(true)
        phone.await("driving") { (phone.service.snapshot.motion?.speedMps ?: 0.0) > FAR_ENOUGH_MPS }
        phone.await("the first waypoint") { phone.service.snapshot.goals.firstOrNull { it.current }?.name == "2" }

        board.destroy()
        phone.await("the loss") { PhoneFailsafe.Hazard.BOARD_LOST in phone.service.snapshot.hazards }
        phone.await("the stop") { phone.service.snapshot.emergency != null }
        assertThat(said.readText()).contains("host 127.0.0.1")
    }
}
