package org.u2sa.android.sensor

import java.nio.file.Path
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.u2sa.core.launch.LaunchOptions
import org.u2sa.core.launch.RunningSystem
import org.u2sa.core.launch.SystemFile
import org.u2sa.device.port.Camera
import org.u2sa.device.port.CameraFrame
import org.u2sa.device.CameraSensor
import org.u2sa.interfaces.BadInputException
import org.u2sa.service.ServiceContext

@Timeout(60)
class CameraHookTest {
    @TempDir
    lateinit var folder: Path
    private val cameras = mutableListOf<TestCamera>()

    /** Looks, and does nothing else. */
    class Eye(context: ServiceContext, camera: Camera) : CameraSensor(context, "Eye", camera) {
        override fun look(frame: CameraFrame) = Unit
    }

    /** Does not want to be made. */
    class Blind(context: ServiceContext, camera: Camera) : CameraSensor(context, "Blind", camera) {
        init {
            throw BadInputException("no eyes")
        }

        override fun look(frame: CameraFrame) = Unit
    }

    private fun system(vararg classes: String): SystemFile {
        val file = folder.resolve("system.xml")
        val services = classes.joinToString("") { "<service class=\"$it\"/>" }
        file.toFile().writeText("<system id=\"test\">$services</system>")
        return SystemFile.read(file)
    }

    private fun run(system: SystemFile): RunningSystem {
        val options = LaunchOptions().logDirectory(folder.resolve("logs")).override("CommunicationManager", "BROKER", "none")
        CameraHook(system).configure(options) { TestCamera().also(cameras::add) }
        return RunningSystem.start(system, options)
    }

    @Test
    fun start_serviceThatLooks_isGivenACameraThatItCloses() {
        run(system(Eye::class.java.name)).use { running ->
            assertThat(running.services()).hasOnlyElementsOfType(Eye::class.java)
            assertThat(cameras).hasSize(1).noneMatch { it.isClosed }
        }
        assertThat(cameras).allMatch { it.isClosed }
    }

    @Test
    fun start_serviceThatCannotBeMade_saysItsOwnWordsAndClosesTheCamera() {
        assertThatThrownBy { run(system(Blind::class.java.name)) }.hasMessageContaining("no eyes")
        assertThat(cameras).hasSize(1).allMatch { it.isClosed }
    }

    @Test
    fun isWanted_onlyWhereAServiceLooks() {
        assertThat(CameraHook(system(Eye::class.java.name)).isWanted).isTrue()
        assertThat(CameraHook(system("org.u2sa.estimation.PassThroughStateEstimator", "not.There")).isWanted).isFalse()
    }
}
