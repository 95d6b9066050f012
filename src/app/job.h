// Slow work as the editor asks for it: one job at a time, away from the thread that draws. What
// goes in and what comes out are plain values that can cross to another thread or to a worker.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "files/sprites.h"
#include "model/stages.h"

namespace artisketch {

struct JobRequest {
  enum class Kind {
    reconstruct,  // a model, from calibrated poses if the options say so
    calibrate,    // poses alone
    parts,        // some parts' surfaces, for a picture while their document is edited
    spheres,      // those that join the parts of a document as it is posed, and nothing else
    sprites,      // a sheet of one of a model's clips
  };
  Kind kind = Kind::reconstruct;
  std::string document;     // as document_text writes it; drawings, where wanted, as data: URIs
  std::vector<Part> parts;  // in place of a document, where parts alone are wanted
  // Of a calibration only the method counts; drawings come from `document`.
  PipelineOptions options;
  // Of sprites, in place of a document: the model, what is wanted of it, and their files' name.
  std::string glb;
  SpriteOptions sprites;
  std::string name;
};

// A part for a picture: not one triangle more than its outlines need.
struct PartMesh {
  int joint = 0;
  Mesh mesh;                      // rest space; empty where the part failed
  std::vector<int> frames;        // in which its contours are
  std::vector<double> distances;  // from them, as of view_distances
};

struct JobResult {
  std::string document;                   // the document at the poses that were used
  std::string glb;                        // the model; empty for a calibration
  std::string report;                     // report_text
  std::vector<FrameFit> fits;             // of a model: one per frame
  std::vector<PartCoverage> coverage;     // empty where poses were not calibrated
  std::vector<JointSphere> spheres;       // that joined the parts
  std::vector<std::string> undetermined;  // angles that the silhouettes leave open, in words
  std::vector<std::string> warnings;
  std::vector<PartMesh> parts;  // of a job for parts alone, as the request has them
  std::string sprites;          // an archive, as of sprite_zip
};

// Does the job on this thread. Fails as the stages do, and on a document that cannot be read; lack
// of memory and anything thrown become errors in words.
Result<JobResult> run_job(const JobRequest& request, Run& run);

// The faults of a job that broke off. `grid` is what was asked for, if it was: a coarser one is
// suggested.
Error out_of_memory(std::optional<int> grid);
Error broke_off(const std::string& why);

// Where jobs run. Called from one thread, the one that draws.
class Jobs {
 public:
  virtual ~Jobs() = default;

  // Begins a job; one that is under way is dropped without a word.
  virtual void start(JobRequest request) = 0;
  virtual bool busy() const = 0;
  // How far the job under way is; as it was left where none is.
  virtual Progress progress() const = 0;
  // The outcome of the last job, once.
  virtual std::optional<Result<JobResult>> poll() = 0;
  // Stops the job under way: busy() is false at once, and poll() gives an error of Kind::cancelled.
  virtual void cancel() = 0;
};

}  // namespace artisketch
