package org.u2sa.android.file

import android.content.Context
import android.net.Uri
import android.provider.DocumentsContract
import android.provider.DocumentsContract.Document
import java.io.FileNotFoundException

private const val DEPTH_AT_MOST = 6

/** Sources of files for import. */
fun vehicleFiles(context: Context) = VehicleFiles(context.filesDir)

/** The shipped assets: config and missions. */
fun shippedFiles(context: Context): Sequence<VehicleFiles.Source> =
    sequenceOf("config", "missions").flatMap { assetsBelow(context, it) }

private fun assetsBelow(context: Context, path: String): Sequence<VehicleFiles.Source> {
    val children = context.assets.list(path).orEmpty()
    return if (children.isEmpty()) { // files and empty folders can only be distinguished by opening them
        if (path.endsWith(".xml")) sequenceOf(VehicleFiles.Source(path) { context.assets.open(path) }) else emptySequence()
    } else {
        children.asSequence().flatMap { assetsBelow(context, "$path/$it") }
    }
}

/** Documents of any app, chosen by the Storage Access Framework's pickers and read on demand. */
class Documents(private val context: Context) {
    /** Display name of a document. */
    fun name(document: Uri): String = rows(document).firstOrNull()?.name ?: document.lastPathSegment.orEmpty()

    /** All files in the folder of a tree that the user chose. */
    fun below(tree: Uri): Sequence<VehicleFiles.Source> = below(tree, DocumentsContract.getTreeDocumentId(tree), "", 0)

    /** Name of the folder. */
    fun treeName(tree: Uri): String =
        name(DocumentsContract.buildDocumentUriUsingTree(tree, DocumentsContract.getTreeDocumentId(tree)))

    private fun below(tree: Uri, folder: String, path: String, depth: Int): Sequence<VehicleFiles.Source> {
        if (depth > DEPTH_AT_MOST) {
            return emptySequence()
        }
        return rows(DocumentsContract.buildChildDocumentsUriUsingTree(tree, folder)).asSequence().flatMap { row ->
            val below = if (path.isEmpty()) row.name else "$path/${row.name}"
            if (row.type == Document.MIME_TYPE_DIR) {
                below(tree, row.id, below, depth + 1)
            } else {
                val uri = DocumentsContract.buildDocumentUriUsingTree(tree, row.id)
                sequenceOf(VehicleFiles.Source(below) { open(uri) })
            }
        }
    }

    private class Row(val id: String, val name: String, val type: String)

    private fun rows(uri: Uri): List<Row> {
        val columns = arrayOf(Document.COLUMN_DOCUMENT_ID, Document.COLUMN_DISPLAY_NAME, Document.COLUMN_MIME_TYPE)
        return context.contentResolver.query(uri, columns, null, null, null)?.use { cursor ->
            buildList {
                while (cursor.moveToNext()) {
                    add(Row(cursor.getString(0), cursor.getString(1).orEmpty(), cursor.getString(2).orEmpty()))
                }
            }
        } ?: emptyList()
    }

    /** Opens a document. */
    fun open(document: Uri) = context.contentResolver.openInputStream(document)
        ?: throw FileNotFoundException("$document: its application did not provide it")
}
