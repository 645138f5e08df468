/** Services of a running system, their condition, and the data flow between them. */
package org.u2sa.gcs.services;
