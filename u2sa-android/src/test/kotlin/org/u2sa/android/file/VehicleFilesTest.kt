package org.u2sa.android.file

import java.io.File
import java.io.IOException
import java.io.InputStream
import java.nio.file.Path
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.u2sa.interfaces.BadInputException

private const val SYSTEM =
    "<system id=\"a\"><service class=\"org.u2sa.estimation.PassThroughStateEstimator\"/></system>"
private const val MISSION = "<mission><waypoint><name>1</name><reference>Global</reference><x>-81.0</x><y>29.0</y></waypoint></mission>"

class VehicleFilesTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var files: VehicleFiles

    @BeforeEach
    fun make() {
        files = VehicleFiles(folder.resolve("app").toFile())
    }

    private fun source(path: String, text: String) = VehicleFiles.Source(path) { text.byteInputStream() }

    @Test
    fun install_newVersion_replacesWhatWasThere() {
        files.install(sequenceOf(source("config/a/system.xml", SYSTEM), source("config/a/old.xml", "")), "1")
        assertThat(files.systemFiles()).containsExactly("shipped/config/a/system.xml")

        files.install(sequenceOf(source("config/b/system.xml", SYSTEM)), "1")
        assertThat(files.systemFiles()).containsExactly("shipped/config/a/system.xml")

        files.install(sequenceOf(source("config/b/system.xml", SYSTEM)), "2")
        assertThat(files.systemFiles()).containsExactly("shipped/config/b/system.xml")
    }

    @Test
    fun install_brokenHalfway_isMadeAnewNextTime() {
        val broken = VehicleFiles.Source("config/b.xml") { throw IOException("disk full") }
        assertThatThrownBy { files.install(sequenceOf(source("config/system.xml", SYSTEM), broken), "1") }
            .isInstanceOf(BadInputException::class.java).hasMessageContaining("disk full")

        files.install(sequenceOf(source("config/system.xml", SYSTEM), source("config/b.xml", "")), "1")
        assertThat(folder.resolve("app/system/shipped/config/b.xml")).exists()
    }

    @Test
    fun import_folderWithASystem_canBeChosen() {
        val names = files.import("my rover", sequenceOf(source("system.xml", SYSTEM), source("Control.xml", "<configuration/>")))

        assertThat(names).containsExactly("my rover/system.xml")
        assertThat(files.system(names[0]).readText()).isEqualTo(SYSTEM)
    }

    @Test
    fun import_folderWithoutASystem_leavesTheOneBefore() {
        files.import("rover", sequenceOf(source("system.xml", SYSTEM)))
        assertThatThrownBy { files.import("rover", sequenceOf(source("notes.txt", "x"))) }
            .isInstanceOf(BadInputException::class.java).hasMessageContaining("system*.xml")

        assertThat(files.systemFiles()).containsExactly("rover/system.xml")
    }

    @Test
    fun import_pathThatLeadsOut_isRefused() {
        assertThatThrownBy { files.import("rover", sequenceOf(source("../../run-state", "RUNNING"))) }
            .isInstanceOf(BadInputException::class.java).hasMessageContaining("points outside")
        assertThat(files.runState).doesNotExist()
        assertThat(files.import("../..", sequenceOf(source("system.xml", SYSTEM)))).allMatch { !it.contains("..") }
    }

    @Test
    fun import_endlessFile_isRefused() {
        val endless = VehicleFiles.Source("system.xml") {
            object : InputStream() {
                override fun read() = 'x'.code
            }
        }
        assertThatThrownBy { files.import("rover", sequenceOf(endless)) }
            .isInstanceOf(BadInputException::class.java).hasMessageContaining("larger than 4 MB")
    }

    @Test
    fun import_manyFiles_isRefused() {
        val many = generateSequence(0) { it + 1 }.map { source("$it.xml", "") }
        assertThatThrownBy { files.import("rover", many) }.hasMessageContaining("more than 500 files")
    }

    @Test
    fun system_wrongFile_namesTheLine() {
        files.import("rover", sequenceOf(source("system.xml", "<system id=\"a\">\n<service/>\n</system>")))
        assertThatThrownBy { files.system("rover/system.xml") }
            .isInstanceOf(BadInputException::class.java).hasMessageContaining("line 2")
    }

    @Test
    fun importMission_rightAndWrong_keepsTheRightOne() {
        assertThat(files.importMission("loop.xml") { MISSION.byteInputStream() }).isEqualTo("loop.xml")
        assertThatThrownBy { files.importMission("loop.xml") { "<mission/>".byteInputStream() } }
            .isInstanceOf(BadInputException::class.java)

        assertThat(files.mission("loop.xml")!!.readText()).isEqualTo(MISSION)
        assertThat(files.mission("other.xml")).isNull()
        assertThatThrownBy { files.mission("../run-state") }.hasMessageContaining("points outside")
    }

    @Test
    fun keepNewest_manyRuns_deletesTheOldest() {
        listOf("2026-01-01", "2026-01-03", "2026-01-02").forEach { File(files.logs, "$it/a.log").apply { parentFile.mkdirs() }.writeText(it) }
        val archive = LogArchive(files.logs)
        assertThat(archive.isEmpty()).isFalse()

        archive.keepNewest(2)
        assertThat(files.logs.list()).containsExactlyInAnyOrder("2026-01-02", "2026-01-03")
    }

    @Test
    fun writeTo_twoRuns_holdsEachLogUnderItsRun() {
        listOf("1", "2").forEach { File(files.logs, "$it/a.log").apply { parentFile.mkdirs() }.writeText("run $it") }
        val bytes = java.io.ByteArrayOutputStream()
        LogArchive(files.logs).writeTo(bytes)

        val found = mutableMapOf<String, String>()
        java.util.zip.ZipInputStream(bytes.toByteArray().inputStream()).use { zip ->
            generateSequence { zip.nextEntry }.forEach { found[it.name] = zip.readBytes().decodeToString() }
        }
        assertThat(found).isEqualTo(mapOf("1/a.log" to "run 1", "2/a.log" to "run 2"))
    }
}
