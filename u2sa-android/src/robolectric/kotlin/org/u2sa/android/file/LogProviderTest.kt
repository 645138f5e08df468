package org.u2sa.android.file

import android.provider.OpenableColumns
import java.io.File
import java.io.FileNotFoundException
import java.util.zip.ZipInputStream
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.u2sa.android.OnPhone

@RunWith(RobolectricTestRunner::class)
class LogProviderTest {
    private val application = OnPhone().application
    private val provider = Robolectric.setupContentProvider(LogProvider::class.java)
    private val uri = LogProvider.uri(application)

    @Test
    fun openFile_logsOfOneRun_areAZipFile() {
        File(application.filesDir, "logs/1/Phone.log").apply { parentFile!!.mkdirs() }.writeText("a line")

        val found = provider.openFile(uri, "r").use { descriptor ->
            OnPhone().await("all of it") { // Robolectric's pipe is a file: its reader does not wait for the writer
                Thread.getAllStackTraces().keys.none { it.name == "u2sa-log-archive" }
            }
            ZipInputStream(java.io.FileInputStream(descriptor.fileDescriptor)).use { zip ->
                zip.nextEntry.name to zip.readBytes().decodeToString()
            }
        }
        assertThat(found).isEqualTo("1/Phone.log" to "a line")
    }

    @Test
    fun openFile_forWriting_isRefused() {
        assertThatThrownBy { provider.openFile(uri, "w") }.isInstanceOf(FileNotFoundException::class.java)
    }

    @Test
    fun query_name_isAZipFilesName() {
        provider.query(uri, null, null, null, null).use { cursor ->
            assertThat(cursor.moveToFirst()).isTrue()
            assertThat(cursor.getString(cursor.getColumnIndexOrThrow(OpenableColumns.DISPLAY_NAME))).isEqualTo("u2sa-logs.zip")
        }
        assertThat(provider.getType(uri)).isEqualTo("application/zip")
    }
}
