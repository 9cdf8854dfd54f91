#include "apps/study/verbs.hpp"
#include "apps/verbs.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace matrigrate::apps {

namespace {

void add_common(CLI::App& verb, StudyOptions& options, const char* quiet) {
  verb.add_flag("--json", options.json, "Print the outcome as one JSON object");
  verb.add_flag("--quiet", options.quiet, quiet);
}

void add_file(CLI::App& verb, StudyOptions& options) {
  verb.add_option("FILE", options.file, "A study file, or the name of a study of matrigrate list")->required();
  verb.add_option("-o,--output", options.folder, "Folder of the study (default: <file>-study)");
}

void add_jobs(CLI::App& verb, StudyOptions& options) {
  verb.add_option("--jobs", options.jobs,
                  "Runs at a time, one thread each, or more where they are fewer (default: the number of cores)")
      ->check(CLI::Range(1, 4096));
}

void add_retry(CLI::App& verb, StudyOptions& options) {
  verb.add_flag("--retry-failed", options.retry_failed,
                "Compute again also what failed numerically; it will fail again unless the program has changed");
}

void add_local(CLI::App& group, Action& chosen) {
  const auto plan = std::make_shared<StudyOptions>();
  CLI::App* verb = group.add_subcommand("plan", "Points, runs, expected time and disk; writes nothing");
  add_file(*verb, *plan);
  add_jobs(*verb, *plan);
  verb->add_flag("--json", plan->json, "Print the plan as JSON: points with their settings, runs with their seeds");
  verb->callback([plan, &chosen] {
    chosen = [plan] { return print_plan(read_study_file(*plan), job_count(plan->jobs), plan->json); };
  });
  const auto run = std::make_shared<StudyOptions>();
  verb = group.add_subcommand("run", "Compute what is missing, several runs at a time; then collect");
  add_file(*verb, *run);
  add_jobs(*verb, *run);
  add_retry(*verb, *run);
  add_common(*verb, *run, "Show no progress");
  verb->footer(
      "A run that fails does not stop the others: it is listed with its reason, and the exit code is 4. A full\n"
      "disk stops all: exit code 5. Ctrl-C or a signal to terminate is passed on to the runs: 130 or 75.\n"
      "The same command again computes what is missing, and nothing else.");
  verb->callback([run, &chosen] { chosen = [run] { return run_study(*run); }; });
}

void add_reading(CLI::App& group, Action& chosen) {
  const auto status = std::make_shared<StudyOptions>();
  CLI::App* verb =
      group.add_subcommand("status", "How many runs are done, how far others are, and why some are not done");
  verb->add_option("DIR", status->folder, "Folder of a study")->required();
  verb->add_flag("--json", status->json, "Print it as one JSON object");
  verb->callback([status, &chosen] { chosen = [status] { return show_status(*status); }; });
  const auto gather = std::make_shared<StudyOptions>();
  verb = group.add_subcommand("collect", "Gather results and statistics of the runs that are done, at any time");
  verb->add_option("DIR", gather->folder, "Folder of a study")->required();
  add_common(*verb, *gather, "Print no tables");
  verb->footer("Writes results.csv (a row per run), groups.csv, statistics.csv, correlations.csv and report.html;\n"
               "of at most 60 points paths.csv, msd.csv and adhesions.csv;\n"
               "with claims claims.csv.");
  verb->callback([gather, &chosen] { chosen = [gather] { return collect_study(*gather); }; });
}

void add_slurm_options(CLI::App& verb, SubmitOptions& options) {
  SlurmOptions& slurm = options.slurm;
  verb.add_option("--account", slurm.account, "Slurm's account that the time is charged to");
  verb.add_option("--partition", slurm.partition, "Slurm's partition, or several with commas between");
  verb.add_option("--qos", slurm.qos, "Slurm's quality of service");
  verb.add_option("--time", slurm.time, "Time limit of a task, as in 12:00:00");
  verb.add_option("--mem", slurm.memory, "Memory of a task, as in 500M");
  verb.add_option("--mail-user", slurm.mail_user, "Address that Slurm mails to when the job ends or fails");
  verb.add_option("--throttle", slurm.throttle, "Largest number of tasks at a time (default: as Slurm decides)")
      ->check(CLI::Range(0, 100000));
  verb.add_option("--cpus", slurm.cpus, "Threads per task; never changes a result (default: 1)")
      ->check(CLI::Range(1, 1024));
  verb.add_option("--chunk", options.chunk,
                  "Runs per task, one after the other (default: as few as fit into 1000 tasks)")
      ->check(CLI::Range(0, 100000));
  verb.add_option("--launcher", options.launcher,
                  "What a task calls in place of this program, as in \"apptainer exec /lab/x.sif matrigrate\"")
      ->check([](const std::string& words) {
        return CLI::detail::split_up(words).empty() ? std::string("names no program") : std::string();
      });
  verb.add_option("SBATCH", slurm.more, "After --: further options for sbatch, as in -- --constraint=avx2");
}

void add_slurm(CLI::App& group, Action& chosen) {
  const auto submit = std::make_shared<SubmitOptions>();
  CLI::App* verb = group.add_subcommand("submit", "Hand what is missing to Slurm, as a job array");
  add_file(*verb, submit->study);
  add_slurm_options(*verb, *submit);
  add_retry(*verb, submit->study);
  verb->add_flag("--json", submit->study.json, "Print {folder, job, runs, tasks}");
  verb->footer(
      "Writes submit.sh into the folder and calls sbatch. A task that is stopped before its end queues itself\n"
      "again. The results are those of `study run`, to the bit. What stands after -- is handed to sbatch as it is.");
  verb->callback([submit, &chosen] { chosen = [submit] { return submit_study(*submit); }; });
  const auto task = std::make_shared<TaskOptions>();
  verb = group.add_subcommand("task", "One task of a job array; called by submit.sh");
  verb->add_option("DIR", task->folder, "Folder of a study")->required();
  verb->add_option("INDEX", task->index, "Number of the task")->required()->check(CLI::Range(0, 100000));
  verb->add_option("--list", task->list, "Which run belongs to which task, a file in the folder")->required();
  verb->callback([task, &chosen] { chosen = [task] { return compute_task(*task); }; });
}

} // namespace

void add_study(CLI::App& app, Action& chosen) {
  CLI::App* group = app.add_subcommand("study", "Many runs: plan, compute, collect and compare them");
  group->require_subcommand(1);
  group->footer("A study file names a scenario, what to vary and how often: see docs/studies.md. Its folder holds\n"
                "study.resolved.toml, runs/<hash>/ (the same run is never computed twice) and the results.");
  add_local(*group, chosen);
  add_reading(*group, chosen);
  add_slurm(*group, chosen);
}

} // namespace matrigrate::apps
