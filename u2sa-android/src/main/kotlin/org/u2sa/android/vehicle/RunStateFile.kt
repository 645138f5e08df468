package org.u2sa.android.vehicle

import java.io.File
import java.io.IOException
import org.u2sa.interfaces.BadInputException

/**
 * Whether a vehicle runs, where a crash cannot take it: written before the first service starts and after the last has ended.
 * A new process that finds RUNNING knows that the one before died.
 *
 * Not safe for several threads: it belongs to one [VehicleHost].
 */
class RunStateFile(private val file: File) {
    /** True if a process said that a vehicle runs and never said that it ended. A file that cannot be read counts as that. */
    fun saysRunning(): Boolean = file.exists() && content() != STOPPED

    private fun content(): String = try {
        file.readText().trim()
    } catch (e: IOException) {
        "unreadable: $e"
    }

    /** @throws BadInputException if it cannot be written: then nothing may start, as nobody would know after a crash */
    fun running() = write(RUNNING)

    /** @throws BadInputException if it cannot be written */
    fun stopped() = write(STOPPED)

    private fun write(text: String) {
        val next = File(file.path + ".next")
        try {
            file.parentFile?.mkdirs()
            next.outputStream().use {
                it.write(text.toByteArray())
                it.fd.sync() // a phone whose battery is pulled out keeps it too
            }
            if (!next.renameTo(file)) { // atomic: a reader sees the old or the new
                throw IOException("cannot be renamed to ${file.name}")
            }
        } catch (e: IOException) {
            throw BadInputException("$file: the state of the vehicle cannot be written: ${e.message}", e)
        }
    }

    private companion object {
        const val RUNNING = "RUNNING"
        const val STOPPED = "STOPPED"
    }
}
