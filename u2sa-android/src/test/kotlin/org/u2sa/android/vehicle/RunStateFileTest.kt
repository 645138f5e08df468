package org.u2sa.android.vehicle

import java.nio.file.Path
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.u2sa.interfaces.BadInputException

class RunStateFileTest {
    @TempDir
    lateinit var folder: Path

    private fun path() = folder.resolve("deep/run-state").toFile()

    @Test
    fun saysRunning_neverWritten_isFalse() = assertThat(RunStateFile(path()).saysRunning()).isFalse()

    @Test
    fun saysRunning_afterAnotherProcessDied_isTrue() {
        RunStateFile(path()).running()
        assertThat(RunStateFile(path()).saysRunning()).isTrue()

        RunStateFile(path()).stopped()
        assertThat(RunStateFile(path()).saysRunning()).isFalse()
    }

    @Test
    fun saysRunning_brokenFile_isTrueToBeOnTheSafeSide() {
        RunStateFile(path()).stopped()
        path().writeText("STOP")
        assertThat(RunStateFile(path()).saysRunning()).isTrue()
    }

    @Test
    fun running_placeIsAFile_saysSo() {
        folder.resolve("deep").toFile().writeText("in the way")
        assertThatThrownBy { RunStateFile(path()).running() }
            .isInstanceOf(BadInputException::class.java)
            .hasMessageContaining("run-state")
    }
}
