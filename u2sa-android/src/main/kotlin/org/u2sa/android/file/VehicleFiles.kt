package org.u2sa.android.file

import java.io.File
import java.io.IOException
import java.io.InputStream
import org.u2sa.core.launch.SystemFile
import org.u2sa.mission.Mission
import org.u2sa.interfaces.BadInputException

private const val FILE_BYTES_AT_MOST = 4L shl 20
private const val FILES_AT_MOST = 500

/**
 * The app's private folder: configurations, missions, logs and the run state. External files are copied here and validated
 * before use; external names never resolve outside it.
 *
 * @param root the folder, created if absent
 */
class VehicleFiles(private val root: File) {
    private val systems = File(root, "system")
    private val missions = File(root, "missions")

    /** Folder of all logs, one subfolder per run. */
    val logs = File(root, "logs")

    /** Marks whether a vehicle is running. */
    val runState = File(root, "run-state")

    /** An external file: its path relative to the chosen folder, and its content. */
    class Source(val path: String, val open: () -> InputStream)

    /**
     * Installs the files shipped with the app, replacing those of another version.
     *
     * @throws BadInputException if they cannot be copied
     */
    fun install(shipped: Sequence<Source>, version: String) {
        val folder = File(systems, SHIPPED)
        val installed = File(systems, "$SHIPPED.version")
        if (!installed.isFile || installed.readText() != version) {
            folder.deleteRecursively()
            copyAll(shipped, folder)
            copy(Source(installed.name) { version.byteInputStream() }, installed) // written last, so an incomplete copy is repeated
        }
    }

    /**
     * Imports a configuration folder, replacing one of the same name.
     *
     * @return the system files in it, as [systemFiles] names them; at least one
     * @throws BadInputException if it cannot be read, is too large, or lists no system; the previous one is then kept
     */
    fun import(name: String, files: Sequence<Source>): List<String> {
        val folder = File(systems, plain(name).ifEmpty { "imported" })
        if (folder.name == SHIPPED) {
            throw BadInputException("\"$SHIPPED\" is the name of the application's own configurations; rename the folder")
        }
        val next = File(systems, folder.name + ".next")
        next.deleteRecursively()
        try {
            copyAll(files, next)
            if (systemFilesIn(next).isEmpty()) {
                throw BadInputException("$name: contains no system*.xml, which lists a system's services")
            }
            folder.deleteRecursively()
            if (!next.renameTo(folder)) {
                throw BadInputException("$name: cannot be moved into place")
            }
        } finally {
            next.deleteRecursively()
        }
        return systemFilesIn(folder).map(::nameOf)
    }

    /** Names of all available system files. */
    fun systemFiles(): List<String> = systems.listFiles().orEmpty()
        .filter { it.isDirectory && !it.name.endsWith(".next") }.sortedBy(File::getName).flatMap(::systemFilesIn).map(::nameOf)

    private fun systemFilesIn(folder: File): List<File> = folder.walkTopDown()
        .filter { it.isFile && it.name.startsWith("system") && it.name.endsWith(".xml") }.sortedBy(File::getPath).toList()

    private fun nameOf(file: File) = file.relativeTo(systems).invariantSeparatorsPath

    /**
     * Returns a system file by name.
     *
     * @throws BadInputException if it is missing or invalid; names the line
     */
    fun system(name: String): File {
        val file = inside(systems, name)
        SystemFile.read(file.toPath())
        return file
    }

    /**
     * Imports a mission, replacing one of the same name.
     *
     * @return its name for [mission]
     * @throws BadInputException if it is invalid; names the line. The previous one is kept
     */
    fun importMission(name: String, open: () -> InputStream): String {
        missions.mkdirs()
        val plain = plain(name).ifEmpty { "mission.xml" }
        val next = File(missions, "$plain.next")
        try {
            copy(Source(plain, open), next)
            Mission.load(next.toPath())
            if (!next.renameTo(File(missions, plain))) {
                throw BadInputException("$name: cannot be moved into place")
            }
        } finally {
            next.delete()
        }
        return plain
    }

    /** A mission by name; null if it no longer exists. */
    fun mission(name: String): File? = inside(missions, name).takeIf(File::isFile)

    private fun copyAll(files: Sequence<Source>, folder: File) {
        var count = 0
        for (file in files) {
            if (++count > FILES_AT_MOST) {
                throw BadInputException("more than $FILES_AT_MOST files; expected a folder with a configuration")
            }
            copy(file, inside(folder, file.path))
        }
    }

    private fun copy(source: Source, target: File) {
        try {
            target.parentFile?.mkdirs()
            source.open().use { from -> target.outputStream().use { bounded(source.path, from).copyTo(it) } }
        } catch (e: IOException) {
            throw BadInputException("${source.path}: cannot be copied: ${e.message}", e)
        } catch (e: SecurityException) { // the provider revoked access
            throw BadInputException("${source.path}: cannot be read: ${e.message}", e)
        }
    }

    private fun bounded(path: String, from: InputStream): InputStream = object : InputStream() {
        private var left = FILE_BYTES_AT_MOST

        override fun read(): Int = from.read().also { if (it >= 0) count(1) }

        override fun read(buffer: ByteArray, offset: Int, length: Int): Int =
            from.read(buffer, offset, length).also { if (it > 0) count(it) }

        private fun count(bytes: Int) {
            left -= bytes
            if (left < 0) {
                throw IOException("$path is larger than ${FILE_BYTES_AT_MOST shr 20} MB")
            }
        }
    }

    private fun inside(folder: File, path: String): File {
        val file = File(folder, path)
        if (!file.canonicalPath.startsWith(folder.canonicalPath + File.separator)) {
            throw BadInputException("\"$path\" points outside the application's folder")
        }
        return file
    }

    private fun plain(name: String) = name.replace(Regex("[^\\p{L}\\p{N}._ -]"), "_").trim('.', ' ')

    companion object {
        /** Folder of the shipped files. */
        const val SHIPPED = "shipped"
    }
}
