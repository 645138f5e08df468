package org.u2sa.android.vehicle

import java.io.File
import java.io.IOException
import org.u2sa.interfaces.BadInputException

/**
 * Crash-safe record of whether a vehicle is running: written before the first service starts and after the last has ended. A
 * new process that finds RUNNING knows the previous one died.
 *
 * Not thread-safe; owned by one [VehicleHost].
 */
class RunStateFile(private val file: File) {
    /** True if a process recorded a start but no end. An unreadable file counts as true. */
    fun saysRunning(): Boolean = file.exists() && content() != STOPPED

    private fun content(): String = try {
        file.readText().trim()
    } catch (e: IOException) {
        "unreadable: $e"
    }

    /** @throws BadInputException if it cannot be written: then nothing may start, because a crash would go unnoticed */
    fun running() = write(RUNNING)

    /** @throws BadInputException if it cannot be written */
    fun stopped() = write(STOPPED)

    private fun write(text: String) {
        val next = File(file.path + ".next")
        try {
            file.parentFile?.mkdirs()
            next.outputStream().use {
                it.write(text.toByteArray())
                it.fd.sync() // survives a removed battery
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
