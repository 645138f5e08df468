package org.u2sa.android.file

import java.io.File
import java.io.OutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/** All logs as one ZIP file, created while it is read, so no temporary file remains. */
class LogArchive(private val logs: File) {
    /** Whether there are any logs. */
    fun isEmpty(): Boolean = files().none()

    /** Writes the archive; lines logged during writing may be missing. */
    fun writeTo(out: OutputStream) {
        ZipOutputStream(out).use { zip ->
            for (file in files().sortedBy(File::getPath)) {
                zip.putNextEntry(ZipEntry(file.relativeTo(logs).invariantSeparatorsPath).apply { time = file.lastModified() })
                file.inputStream().use { it.copyTo(zip) }
                zip.closeEntry()
            }
        }
    }

    /** Deletes the folders of the oldest runs; a run's name begins with its time. */
    fun keepNewest(runs: Int) {
        logs.listFiles().orEmpty().filter(File::isDirectory).sortedByDescending(File::getName).drop(runs)
            .forEach(File::deleteRecursively)
    }

    private fun files(): Sequence<File> = logs.walkTopDown().filter(File::isFile)
}
