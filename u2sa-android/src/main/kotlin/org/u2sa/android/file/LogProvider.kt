package org.u2sa.android.file

import android.content.ContentProvider
import android.content.ContentValues
import android.content.Context
import android.database.Cursor
import android.database.MatrixCursor
import android.net.Uri
import android.os.ParcelFileDescriptor
import android.provider.OpenableColumns
import android.util.Log
import java.io.FileNotFoundException
import java.io.IOException
import kotlin.concurrent.thread

private const val NAME = "u2sa-logs.zip"
private const val TYPE = "application/zip"

/** Provides the logs only to the app the user shares them with; the provider is not exported. */
class LogProvider : ContentProvider() {
    override fun onCreate() = true

    override fun getType(uri: Uri): String = TYPE

    override fun query(
        uri: Uri,
        projection: Array<String>?,
        selection: String?,
        selectionArgs: Array<String>?,
        sortOrder: String?,
    ): Cursor {
        val columns = (projection ?: arrayOf(OpenableColumns.DISPLAY_NAME)).filter { it == OpenableColumns.DISPLAY_NAME }
        return MatrixCursor(columns.toTypedArray()).apply { addRow(columns.map { NAME }) }
    }

    override fun openFile(uri: Uri, mode: String): ParcelFileDescriptor {
        if (mode != "r") {
            throw FileNotFoundException("$uri can only be read")
        }
        val archive = LogArchive(vehicleFiles(requireNotNull(context)).logs)
        val (from, to) = ParcelFileDescriptor.createReliablePipe()
        thread(name = "u2sa-log-archive", isDaemon = true) {
            try {
                ParcelFileDescriptor.AutoCloseOutputStream(to).use(archive::writeTo)
            } catch (e: IOException) { // the reader disconnected
                Log.w("u2sa", "sharing logs: $e")
            }
        }
        return from
    }

    override fun insert(uri: Uri, values: ContentValues?): Uri? = throw UnsupportedOperationException("$uri can only be read")

    override fun delete(uri: Uri, selection: String?, args: Array<String>?): Int =
        throw UnsupportedOperationException("$uri can only be read")

    override fun update(uri: Uri, values: ContentValues?, selection: String?, args: Array<String>?): Int =
        throw UnsupportedOperationException("$uri can only be read")

    companion object {
        /** URI of its only document. */
        fun uri(context: Context): Uri = Uri.parse("content://${context.packageName}.logs/$NAME")

        /** Display name for the receiving app. */
        const val MIME_TYPE = TYPE
    }
}
