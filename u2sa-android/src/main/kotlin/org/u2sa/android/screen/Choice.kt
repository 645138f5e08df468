package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.app.Activity
import android.app.AlertDialog
import android.content.Intent
import android.net.Uri
import kotlin.concurrent.thread
import org.u2sa.android.file.Documents
import org.u2sa.android.file.vehicleFiles
import org.u2sa.android.vehicle.PhoneSettings
import org.u2sa.interfaces.BadInputException

private const val MISSION_REQUEST = 2
private const val SYSTEM_REQUEST = 3

/** Lets the user choose system and mission with Android's file pickers, and reports errors. */
internal class Choice(private val activity: Activity, private val settings: PhoneSettings, private val tell: (String) -> Unit) {
    private val documents = Documents(activity.applicationContext)
    private val files = vehicleFiles(activity)

    /** Description of the current choice. */
    fun words(): String {
        val own = settings.mission
        val mission = if (own.isEmpty()) Text.MISSION_OF_SYSTEM.of(activity) else Text.MISSION_WITHOUT_FENCE.of(activity, own)
        return Text.CHOSEN.of(activity, settings.system, mission)
    }

    /** Any file type, because few apps report XML's MIME type. */
    fun pickMission() {
        val pick = Intent(Intent.ACTION_OPEN_DOCUMENT).addCategory(Intent.CATEGORY_OPENABLE).setType("*/*")
        activity.startActivityForResult(pick, MISSION_REQUEST)
    }

    /** A known system, or a folder with a new one. */
    fun pickSystem(): AlertDialog {
        val known = files.systemFiles()
        val entries = known + Text.SYSTEM_FOLDER.of(activity)
        return AlertDialog.Builder(activity)
            .setTitle(Text.MENU_SYSTEM.of(activity))
            .setItems(entries.toTypedArray()) { _, which ->
                if (which < known.size) {
                    take { useSystem(known[which]) }
                } else {
                    activity.startActivityForResult(Intent(Intent.ACTION_OPEN_DOCUMENT_TREE), SYSTEM_REQUEST)
                }
            }
            .show()
    }

    private fun useSystem(name: String): String {
        files.system(name) // throws if invalid
        settings.system = name
        settings.mission = "" // belonged to another vehicle
        return Text.SYSTEM_TAKEN.of(activity, name)
    }

    /** Handles a picker's result. */
    fun picked(request: Int, uri: Uri) = when (request) {
        MISSION_REQUEST -> take {
            settings.mission = files.importMission(documents.name(uri)) { documents.open(uri) }
            Text.MISSION_TAKEN.of(activity, settings.mission)
        }
        SYSTEM_REQUEST -> take { useSystem(files.import(documents.treeName(uri), documents.below(uri)).first()) }
        else -> Unit
    }

    /** Copies on a background thread, because documents may come from a network. */
    private fun take(action: () -> String) {
        thread(name = "u2sa-import") {
            val words = try {
                action()
            } catch (e: BadInputException) {
                Text.NOT_TAKEN.of(activity, e.message.orEmpty())
            }
            activity.runOnUiThread { if (!activity.isDestroyed) tell(words) }
        }
    }
}
